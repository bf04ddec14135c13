#' Words of codend
#'
#' One word for one concept, in plans, help, messages and code. Words for netting are those of
#' ISO 1107, words for gear those of FAO, words of mechanics those of engineering.
#'
#' @section Netting:
#' \describe{
#'   \item{twine}{The thread of which netting is made.}
#'   \item{mesh}{The opening between the twines of netting. A diamond mesh has four bars of equal
#'     length, a hexagonal mesh six.}
#'   \item{mesh bar}{The twine between two neighbouring knots of a mesh.}
#'   \item{mesh size}{Length of a full mesh pulled straight in the direction of its diagonal: of
#'     diamond netting two mesh bars, with their knots.}
#'   \item{knot}{Where twines of netting are joined. In the model it is a sphere at a node.}
#'   \item{panel}{A piece of netting of one mesh size and twine, with counts of meshes along its
#'     upper edge, along its lower edge and from one to the other.}
#'   \item{orientation}{How meshes lie in a panel: diamond (T0), square (T45) or turned (T90).}
#'   \item{cutting rate}{Meshes lost or gained across a panel for meshes down it, such as 1N2B: in
#'     turn one point (N) and two bars (B) along its side edge. T is a mesh cut across; AN, AB and
#'     AT are all points, all bars, all meshes (ISO 1532).}
#'   \item{take-up}{Meshes of one panel to those of the next that they are joined to, such as 2:3.}
#'   \item{Rtex}{Resultant linear density of a twine: grams per kilometre of it.}
#'   \item{stretched length}{Length of netting whose meshes are closed: meshes times mesh size.}
#'   \item{hanging ratio}{Length of a rope over the stretched length of the netting that is hung on
#'     it.}
#'   \item{selvedge}{Strong netting or an edge along which a panel is joined.}
#'   \item{seam}{Where edges of panels are joined; they share the points of it.}
#'   \item{solidity}{Projected area of twines and knots over the area of the netting.}
#'   \item{mesh opening}{How far a mesh is open across; the opening stiffness resists it.}
#' }
#' @section Gear:
#' \describe{
#'   \item{gear}{Everything in the water, assembled: netting, ropes, rigid pieces and how they
#'     join.}
#'   \item{kind}{A short form of plan for one sort of gear, such as `bottom_trawl`.}
#'   \item{part}{One named component of the gear: a rope, a panel, a group of pieces, an otter board
#'     or a kite.}
#'   \item{warp}{Rope from the vessel to the otter board or to the net.}
#'   \item{otter board, door}{Board that spreads a trawl by its lift. `door` appears in names of
#'     measures (`door_spread_m`), as the trade says.}
#'   \item{backstrop}{Short rope from an otter board to where the sweep or the bridles begin.}
#'   \item{sweep, bridle, hand rope}{Rope between board and net. A sweep is single, bridles lead on
#'     from it to the wing tips, and hand ropes lead from the board straight to the wing tips.}
#'   \item{head line, footrope}{Rope along the upper, the lower edge of a net's mouth.}
#'   \item{bosom}{Of head line or footrope, what lies between the wings.}
#'   \item{tickler}{Chain ahead of the footrope that stirs the sea bed.}
#'   \item{ground gear}{What protects the footrope and rolls or slides over the sea bed.}
#'   \item{disc}{Of rubber or steel on the ground gear's wire; a bobbin or roller is one too.}
#'   \item{cover}{Netting laced over a section: a lifting bag, a chafer, a second layer.}
#'   \item{grid}{Bars in a frame behind a section, which sort the catch.}
#'   \item{float line, lead line}{Rope with floats, with weights, along the edge of a seine or
#'     gillnet.}
#'   \item{belly line, side line, cross rope}{Rope that strengthens a net along its belly, along the
#'     seams of its sides, and around it.}
#'   \item{wing, square, section, codend}{Netting of a trawl from front to rear.}
#'   \item{piece}{A rigid body at a point: a weight, a float, a hook, a ring.}
#'   \item{kite}{Rigid or canvas surface that lifts the head line. One that pulls down is a
#'     depressor.}
#'   \item{purse wire}{Rope through the rings of a purse seine, which closes it from below.}
#'   \item{main line, branch line}{Of a longline: the long rope, and the ropes with hooks on it.}
#'   \item{basket}{Stretch of a longline between two float lines.}
#'   \item{demersal seine}{A net between two long ropes (seine ropes, its warps) on the sea bed,
#'     which are hauled together and herd: Danish, by an anchored vessel, or Scottish (fly
#'     dragging), by one that tows.}
#'   \item{shooting, hauling}{Setting the gear from the vessel, and bringing it back.}
#' }
#' @section Plan and results:
#' \describe{
#'   \item{plan}{What the designer writes: the fields of a YAML file.}
#'   \item{schedule}{What changes with time during a tow: speed, course, warps, current, catch.}
#'   \item{mesh of the model}{The gear as nodes and the elements between them; `state$lattice`.}
#'   \item{node}{A point of the model with a position and a velocity.}
#'   \item{element}{What acts between nodes: a bar, a netting cell, a sphere, a rigid surface.}
#'   \item{bar}{A straight spring between two nodes with the drag of a cylinder. It stands for one
#'     or many mesh bars, or for a stretch of rope.}
#'   \item{state}{Positions, velocities, tensions and forces at one moment.}
#'   \item{settle}{To find the state of static equilibrium in a steady flow.}
#'   \item{tow}{To march through time by a schedule.}
#'   \item{trajectory}{The states of a tow that are kept, in the order of time.}
#'   \item{frame}{One of the states of a trajectory.}
#'   \item{measure}{A number computed from a state, with a name, a unit and a definition.}
#'   \item{spread}{Horizontal distance across the tow, between boards or between wing ends.}
#' }
#' @section Forces and solution:
#' \describe{
#'   \item{drag, lift}{Force of the water along its relative velocity, and at right angles to it.}
#'   \item{angle of attack}{Angle between a surface and the relative flow.}
#'   \item{heel, trim}{Rotation of a board about its chord, and about its normal.}
#'   \item{polar}{Coefficients of lift and drag against the angle of attack.}
#'   \item{added mass}{Mass of water that accelerates with a body.}
#'   \item{screen}{Netting whose drag and lift follow from its solidity and its angle to the flow,
#'     not from the sum over its twines.}
#'   \item{wake, shielding}{The slowed water behind netting is its wake. That it lowers the drag of
#'     what is there is shielding.}
#'   \item{slack}{Without tension; ropes and twines do not push.}
#'   \item{strength}{Breaking load, at which a rope breaks.}
#'   \item{residual}{Net force on the free nodes, zero in equilibrium.}
#'   \item{level}{One of the meshes of the model, from coarse to fine, through which a gear is
#'     settled.}
#'   \item{scheme}{Formula by which a tow goes from one time to the next.}
#' }
#' @seealso [measures()] for what each measure means.
#' @examples
#' # the words of a plan in use
#' names(read_gear("poly_noreastern_trawl")$plan)
#' @name glossary
NULL
