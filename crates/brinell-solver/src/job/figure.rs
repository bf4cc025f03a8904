//! The names of all figures, the rows of an answer. A row of the table makes its identifier, its label, its quantity, the
//! kind of its bar and its line in `docs/reference/result.md`; a row of an answer that is not in
//! the table does not compile.

use strum::{IntoStaticStr, VariantArray};

use super::{Named, Quantity};

/// Where the bar of a figure comes from, unless its row says otherwise.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BarKind {
    /// Two meshes, and two divisions into increments.
    Mesh,
    /// A closed form of the job's own data.
    Exact,
    /// A closed form where there is one, else two meshes.
    MeshOrExact,
    /// Nothing bounds its error.
    None,
}

impl BarKind {
    const fn words(self) -> &'static str {
        match self {
            Self::Mesh => "two meshes",
            Self::Exact => "exact",
            Self::MeshOrExact => "exact, or two meshes",
            Self::None => "none",
        }
    }
}

macro_rules! names {
    ($($Name:ident $label:literal $quantity:ident $kind:ident $meaning:literal;)*) => {
        /// The name of a row.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
        #[strum(serialize_all = "snake_case")]
        pub enum Name {
            $(#[doc = $meaning] $Name,)*
        }

        impl Name {
            /// Returns the name for a person.
            pub const fn label(self) -> &'static str {
                match self {
                    $(Self::$Name => $label,)*
                }
            }

            /// Returns the quantity; forces, energies and slopes are those of the whole contact.
            pub const fn quantity(self) -> Quantity {
                match self {
                    $(Self::$Name => Quantity::$quantity,)*
                }
            }

            /// Returns where its bar comes from.
            pub const fn bar(self) -> BarKind {
                match self {
                    $(Self::$Name => BarKind::$kind,)*
                }
            }

            /// Returns what the figure is.
            pub const fn meaning(self) -> &'static str {
                match self {
                    $(Self::$Name => $meaning,)*
                }
            }
        }
    };
}

impl Named for Name {}

names! {
    Hardness "Hardness" Number Mesh
        "number of a test by a standard; of `berkovich` and `sphere` see `meyer_hardness`";
    ForceFound "Force found" Force Mesh "force under which a figure has the value that is wanted";
    InputFound "Input found" Number Mesh
        "number of the job with which a figure is as wanted; its bar is that of the figure over \
         `input_elasticity`";
    InputElasticity "Elasticity of the figure" Number None
        "relative change of the figure that is wanted over that of the input found";
    FirstYieldForce "First yield" Force Exact
        "force under which a body begins to yield, of half-spaces; `load.onset` looks for `force`";
    FirstYieldPeakPressure "Peak pressure at first yield" Stress None
        "in closed form, of a rounded edge that elements leave out";
    StrainPerPass "Strain per pass" Strain Mesh
        "plastic strain that each steady pass, or pair of passes, adds or moves";
    TrackDepth "Depth of the track" Length Mesh
        "how far the surface has sunk, on the axis";
    ForwardDisplacement "Forward displacement" Length Mesh
        "of the surface along the travel, by the last pass";
    PassStrain "Strain, last pass" Strain Mesh
        "accumulated by the pass, largest of all layers";
    NetStrain "Net strain, last pass" Strain Mesh
        "kept by the pass, largest of all layers";
    LeastSigmaX "Least residual σ_x" Stress Mesh
        "along the travel, least over depth";
    LargestSigmaX "Largest residual σ_x" Stress Mesh
        "along the travel, largest over depth";
    LeastSigmaZ "Least residual σ_z" Stress Mesh
        "across the travel, least over depth";
    LargestSigmaZ "Largest residual σ_z" Stress Mesh
        "across the travel, largest over depth";
    RollingForce "Rolling force" Force Mesh
        "against the travel in the pass, without friction";
    RollingResistance "Rolling resistance" Ratio Mesh "rolling force over the load";
    PassWork "Plastic work of the pass" Force Mesh
        "of plastic flow in both bodies, per length of travel";
    PassStoredEnergy "Energy stored by the pass" Force None
        "change of the elastic energy of the residual stress, per length of travel";
    TractionWork "Work of friction" Force None
        "of the friction on the plastic displacement of the surfaces, per length of travel";
    EnergyGap "Missing in the balance" Ratio None
        "what is missing in the balance of the works of a pass, over the plastic work";
    Friction "Friction" Number Mesh "traction over pressure in the whole contact";
    DentDepth "Dent" Length Mesh "deepest point of the unloaded surface below the undeformed one";
    SurfaceDepth "Surface depth" Length Mesh
        "deepest point of the loaded surface below the undeformed one";
    PileUp "Pile-up" Length Mesh "highest point of the surface above the undeformed one";
    PermanentApproach "Permanent approach" Length Mesh "approach without force";
    ResidualTension "Residual tension" Stress None
        "largest principal stress that the load has left";
    ContactRatio "Real contact area" Ratio Mesh
        "cells in contact over the area of all heights";
    NominalPressure "Nominal pressure" Stress MeshOrExact
        "force over the area of all heights";
    YieldedPart "Area that yields" Ratio None
        "part of the area in contact below which a body has yielded";
    EdgePressure "Edge pressure" Stress None
        "largest pressure of a cell in the outermost rows of a roller";
    Moment "Moment" Energy Mesh "of the pressure about the middle, positive towards y";
    Tilt "Tilt" Angle Mesh "positive where the surfaces are closer at positive y";
    PeakPressure "Peak pressure" Stress Mesh "largest contact pressure";
    MiddlePressure "Pressure in the middle" Stress Mesh
        "contact pressure in the middle, where that is not the peak; of a roller the largest across \
         its middle";
    HalfWidth "Half-width" Length Mesh
        "half of the distance between the ends of the contact; of a circle its radius";
    HalfWidthAcross "Half-width across" Length Mesh
        "half-width of the contact across the travel";
    SemiAxisA "Shorter semi-axis" Length Mesh "shorter semi-axis of the contact";
    SemiAxisB "Longer semi-axis" Length Mesh "longer semi-axis of the contact";
    Approach "Approach" Length Mesh "how far the bodies have approached";
    Force "Force" Force Mesh "contact force";
    MeanPressure "Mean pressure" Stress Mesh "force over the contact";
    MaxPlasticStrain "Largest plastic strain" Strain Mesh
        "accumulated since the bodies were at rest";
    MeanPlasticStrain "Mean plastic strain" Strain Mesh
        "mean equivalent plastic strain over the area of the section that has yielded";
    Utilization "Utilization" Ratio Exact
        "largest von Mises stress of elastic bodies over the yield stress there";
    Margin "Margin to first yield" Number Exact "force of first yield over the force";
    CoreUtilization "Core utilization" Ratio None
        "largest von Mises stress over the yield stress below a hardened case";
    PlasticDepth "Plastic depth" Length None "depth down to which there is plastic strain";
    FatigueUtilization "Fatigue" Ratio Mesh
        "shear stress of a criterion of high-cycle fatigue over the fatigue limit in torsion, largest \
         of all depths";
    RelativeLife "Relative life" Number None
        "passes until fatigue over those of elastic bodies without residual stress under the force: \
         a power of both shear stresses, the middle over exponents from 9 to 10.3 and the error";
    FatigueOfResidualStress "Fatigue by residual stress" Ratio None
        "part of residual and initial stress in the utilization, below zero where it helps";
    ShakedownPressure "Shakedown pressure" Stress Exact
        "Hertz's peak up to which perfect plasticity shakes down";
    KinematicShakedownPressure "Kinematic shakedown" Stress None
        "the same of bodies whose backstress has no bound, on these layers";
    EffectiveRadius "Effective radius" Length Exact
        "reciprocal of the sum of both curvatures across the shorter side of the contact";
    ContactStiffness "Contact stiffness" Stiffness Mesh
        "slope of the force over the approach, with the plastic flow that it brings";
    UnloadingStiffness "Unloading stiffness" Stiffness None
        "slope of the force over the approach where the load begins to fall, of bodies that flow";
    DissipatedWork "Dissipated work" Energy None
        "work on plastic strain that no backstress stores, since the bodies were at rest";
    HalfAngle "Angle of contact" Degrees Mesh
        "over which a pin touches its hole to each side of the middle";
    Orientation "Orientation" Degrees Exact
        "angle from the x of the job to the x of the figures, towards the y of the job";
    ContactArea "Contact area" Area Mesh
        "area of the contact; of heights that of the cells in contact";
    LargestCellPressure "Largest pressure of a cell" Stress None
        "of one cell, where the peak is a mean over neighbours";
    LeastStress "Least stress along the surface" Stress Mesh
        "on the normal below the middle; without force the residual stress";
    LargestVonMises "Largest von Mises stress" Stress Mesh
        "on the normal below the middle, over the strength there, that of the surface being 1";
    PlasticArea "Plastic area" Area Mesh "area of the section that has yielded";
    PlasticVolume "Plastic volume" Volume None "volume of the cells that have yielded";
    PlasticCover "Elastic cover" Length None
        "depth at which the plastic zone begins, 0 where it reaches the surface";
    ReversePlasticStrain "Reverse plastic strain" Strain None
        "largest equivalent plastic strain since the load last began to fall";
    ReversePlasticArea "Area of reverse yield" Area None
        "area of the section with plastic strain since the load last began to fall";
    Work "Work of the force" Energy None "since the bodies were at rest";
    ElasticEnergy "Elastic energy" Energy None "of both bodies";
    PlasticWork "Plastic work" Energy None
        "of the stresses on plastic strain, where a backstress stores a part of it";
    StoredEnergy "Stored energy" Energy None "the part of it that the backstress stores";
    ShearYieldStress "Shear yield stress" Stress Exact
        "of both bodies the lower, where strength does not vary: the scale of the map of shakedown";
    ForceSensitivity "Sensitivity of the target" Number None
        "relative change of the figure that is wanted over that of the force";
    MeyerHardness "Meyer hardness" Stress Mesh
        "force over the area of the indentation under it; the answer of `berkovich` and `sphere`";
    LargeStrainBias "Beside large strains" Ratio None
        "mean pressure over that of a published result with large strains, less 1";
    CurvatureBias "Curvature beside large strains" Ratio None
        "F/h² of a pyramid over that of Dao et al., less 1";
    Diameter "Diameter of the indentation" Length Mesh
        "under the force; of pyramids the diagonal of a square of equal area";
    IndentationDepth "Depth of the indentation" Length Mesh "under the force";
    IndentationArea "Area of the indentation" Area Mesh "under the force";
    PermanentDepth "Depth that is left" Length None "of the indentation without force";
    RimDiameter "Diameter of the rim" Length None
        "circle of the highest points around the indentation that is left";
    EdgeHeight "Height of the edge" Length None
        "edge of the contact under load over the plane surface; below 0 sunk in";
    MeyerExponent "Meyer's exponent" Number None "of the force over the diameter";
    RepresentativeStrain "Representative strain" Strain MeshOrExact
        "Tabor's plastic strain: 0.2 a/R of a ball, 0.08 of a pyramid";
    FlowStress "Flow stress" Stress MeshOrExact "of the curve at the representative strain";
    ConstraintFactor "Constraint factor" Number Mesh
        "mean pressure over the flow stress; Tabor's is 2.8";
    LeastThickness "Least thickness" Length None "of the specimen by the standard";
    OliverPharrStiffness "Oliver and Pharr's stiffness" Stiffness None
        "slope of the unloading curve at its beginning";
    OliverPharrDepth "Oliver and Pharr's depth" Length None
        "contact depth h − 0.75 F/S";
    OliverPharrArea "Oliver and Pharr's area" Area None
        "area of the indenter at that depth";
    OliverPharrModulus "Oliver and Pharr's modulus" Stress Mesh "√π S / (2 √A)";
    OliverPharrHardness "Oliver and Pharr's hardness" Stress Mesh "force over that area";
    ReducedModulus "Reduced modulus" Stress Exact "E* of both materials";
}

/// Returns the table of names in `docs/reference/result.md`.
pub fn table_of_names() -> String {
    let head = "| name | label | quantity | bar | meaning |\n|---|---|---|---|---|\n";
    let row = |name: &Name| {
        let quantity: &str = name.quantity().into();
        let (word, label, bar) = (name.name(), name.label(), name.bar().words());
        format!("| `{word}` | {label} | `{quantity}` | {bar} | {} |\n", name.meaning())
    };
    [head.to_owned()].into_iter().chain(Name::VARIANTS.iter().map(row)).collect()
}
