//! The largest sizes of inputs.
//!
//! Whatever is beyond a limit is an error that says what was found and what is allowed. `docs/model.md` lists the limits.

/// Bytes of a model with all that it includes, of `kane.toml`, of a state.
pub const INPUT_BYTES: usize = 16 << 20;
/// Bytes of a mesh file.
pub const MESH_BYTES: usize = 32 << 20;
/// Bytes of all mesh files of a model.
pub const MESHES_BYTES: usize = 256 << 20;
/// Points of a mesh.
pub const MESH_POINTS: usize = 500_000;
/// Triangles of a mesh.
pub const MESH_FACES: usize = 500_000;
/// Steps that the meshes of a model take: points tried at faces of convex hulls, and corners at others of their polygons.
pub const MESH_STEPS: usize = 300_000_000;
/// Updates of a mass matrix that is factorised in numbers, for the springs that `springdamper` of an MJCF makes.
pub const SPRING_UPDATES: usize = 500_000_000;
/// Bytes of a file that is compared with what is generated, or replaced by it.
pub const OUTPUT_BYTES: usize = 256 << 20;
/// Entries of a list of a model, its bodies among them.
pub const BODIES: usize = 10_000;
/// Characters of a name.
pub const NAME_CHARACTERS: usize = 250;
/// Words of a request.
pub const REQUEST_WORDS: usize = 1_000;
/// Errors of a file that are told, and as many warnings.
pub const TOLD: usize = 1_000;
/// Elements, comments and texts of an XML file.
pub const XML_NODES: u32 = 1_000_000;
/// Attributes of an XML element.
pub const XML_ATTRIBUTES: usize = 250;
/// Declarations of namespaces in an XML file.
pub const XML_NAMESPACES: usize = 100;
/// Numbers of a model that are set at run time.
pub const PARAMETERS: usize = 2_000;
/// Bodies that move, and speeds, of a system in which joints follow others.
pub const FOLLOWING: usize = 250;
/// Speeds of a system of which a function is derived.
pub const SPEEDS: usize = 5_000;
/// Bodies of such a system with all that is fixed to them.
pub const PARTS: usize = 5_000;
/// Numbers that the functions of a module write, all together.
pub const NUMBERS: usize = 250_000;
/// Numbers of the regressor in which base parameters are found, each evaluated at many states.
pub const BASE_REGRESSOR: usize = 250_000;
/// Numbers of a regressor that is derived whole and written packed.
pub const REGRESSOR: usize = 4_000_000;
/// Numbers of an inverse that is derived whole and written packed.
pub const INVERSE: usize = 1_000_000;
/// Terms of the notes' sums where a function is derived as these stand.
pub const TERMS: usize = 100_000;
/// The same where they are evaluated only, for the tests beside a module, all together; one of forces, which holds a whole
/// acceleration, counts as eight of a mass matrix.
pub const EVALUATED_TERMS: usize = 4_000_000;
/// Updates of a mass matrix that is factorised.
pub const UPDATES: usize = 1_000_000;
/// Numbers that a function writes which solves with a mass matrix: an inverse has a column for every speed.
pub const SOLVED: usize = 20_000;
/// Numbers that the derivatives of a function write.
pub const DIFFERENTIATED: usize = 20_000;
/// Operations that second derivatives build, before what is zero or alike falls away.
pub const SECOND: usize = 4_000_000;
/// Speeds, and parts, of a system of which `kane info` counts the operations of all functions.
pub const COUNTED: usize = 100;
/// Bodies of a system of which `kane info` shows the tree and the partitions.
pub const PICTURED_BODIES: usize = 250;
