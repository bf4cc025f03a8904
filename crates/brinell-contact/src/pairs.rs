//! Sets of node pairs.

/// Which pairs are in contact: pair numbers in ascending order, none twice.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct ActiveSet(Vec<usize>);

impl ActiveSet {
    /// The pairs among `0..n` for which `in_contact` holds.
    pub fn from_fn(n: usize, in_contact: impl FnMut(&usize) -> bool) -> Self {
        Self((0..n).filter(in_contact).collect())
    }

    /// The pairs in ascending order.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = usize> + ExactSizeIterator + '_ {
        self.0.iter().copied()
    }

    /// The pairs as a slice, in ascending order.
    pub fn as_slice(&self) -> &[usize] {
        &self.0
    }

    /// Number of pairs in contact.
    pub const fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether no pair is in contact.
    pub const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether pair k is in contact; O(log n).
    pub fn contains(&self, k: usize) -> bool {
        self.0.binary_search(&k).is_ok()
    }

    /// The lowest pair in contact.
    pub fn first(&self) -> Option<usize> {
        self.0.first().copied()
    }

    /// The highest pair in contact.
    pub fn last(&self) -> Option<usize> {
        self.0.last().copied()
    }
}

impl FromIterator<usize> for ActiveSet {
    fn from_iter<I: IntoIterator<Item = usize>>(pairs: I) -> Self {
        let mut pairs: Vec<usize> = pairs.into_iter().collect();
        pairs.sort_unstable();
        pairs.dedup();
        Self(pairs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_sorted_and_free_of_duplicates() {
        let set: ActiveSet = [7, 2, 2, 5].into_iter().collect();
        assert_eq!(set.as_slice(), [2, 5, 7]);
        assert_eq!((set.first(), set.last(), set.len()), (Some(2), Some(7), 3));
        assert!(set.contains(5) && !set.contains(3));
        assert_eq!(set, ActiveSet::from_fn(8, |k| [2, 5, 7].contains(k)));
        assert_eq!(set.iter().next_back(), Some(7));
        assert!(ActiveSet::default().is_empty() && ActiveSet::default().first().is_none());
    }
}
