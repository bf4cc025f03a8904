//! Memory of the machine or the container.

use std::fs;

/// Returns the memory \[bytes\] of the machine or of this process's control group, whichever is
/// less; `None` where the system does not report it.
pub(super) fn machine_memory() -> Option<u64> {
    let groups = fs::read_to_string("/proc/self/cgroup").unwrap_or_default();
    let group = group_limits(&groups).into_iter().filter_map(|path| fs::read_to_string(path).ok());
    let total = fs::read_to_string("/proc/meminfo").ok();
    let total = total.as_deref().and_then(total_memory);
    group.filter_map(|text| text.trim().parse().ok()).chain(total).min()
}

/// Returns the files that may hold a limit of the control groups in a listing (lines
/// `id:controllers:path`), for both versions of the interface. A group's limit also applies to the
/// groups below it.
fn group_limits(listing: &str) -> Vec<String> {
    let mut files = Vec::new();
    for line in listing.lines() {
        let mut parts = line.splitn(3, ':').skip(1);
        let (Some(controllers), Some(path)) = (parts.next(), parts.next()) else { continue };
        let (root, name) = if controllers.is_empty() {
            ("/sys/fs/cgroup", "memory.max")
        } else if controllers.split(',').any(|controller| controller == "memory") {
            ("/sys/fs/cgroup/memory", "memory.limit_in_bytes")
        } else {
            continue;
        };
        let path = path.trim_matches('/');
        let ends = path.match_indices('/').map(|(end, _)| end).chain([path.len()]);
        files.extend(ends.map(|end| format!("{root}/{}/{name}", &path[..end])));
        files.push(format!("{root}/{name}"));
    }
    files
}

/// The total in `/proc/meminfo`.
fn total_memory(text: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix("MemTotal:"))?;
    line.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_versions_of_control_groups_are_understood() {
        assert_eq!(
            group_limits("0::/a/b\n"),
            [
                "/sys/fs/cgroup/a/memory.max",
                "/sys/fs/cgroup/a/b/memory.max",
                "/sys/fs/cgroup/memory.max"
            ]
        );
        let old = group_limits("3:cpu:/x\n5:memory,other:/\n");
        assert_eq!(old.last().unwrap(), "/sys/fs/cgroup/memory/memory.limit_in_bytes");
        assert_eq!(group_limits("nonsense"), Vec::<String>::new());
    }

    #[test]
    fn the_total_is_read() {
        assert_eq!(total_memory("MemFree: 1 kB\nMemTotal:   2048 kB\n"), Some(2 << 20));
        assert_eq!(total_memory(""), None);
    }
}
