#' Glossary
#'
#' Defines the terms that plans, help, messages and guides use. Netting terms follow ISO 1107 and
#' ISO 1532, gear terms follow FAO, and mechanical terms follow engineering use.
#'
#' @section Netting:
#' \describe{
#'   \item{twine}{Thread that netting is made from.}
#'   \item{mesh}{Opening between the twines of netting. A diamond mesh has four bars of equal
#'     length, a hexagonal mesh has six. For the finite-element mesh, see "mesh of the model".}
#'   \item{mesh bar}{Twine between two neighbouring knots of a mesh.}
#'   \item{mesh size}{Length of a full mesh that is pulled straight along its diagonal. In diamond
#'     netting it is two mesh bars with their knots.}
#'   \item{mesh opening}{Distance across an open mesh. The opening stiffness of the netting resists
#'     it.}
#'   \item{knot}{Joint of two twines in netting. The model treats it as a sphere at a node.}
#'   \item{panel}{Piece of netting with one mesh size and one twine. Counts of meshes define its
#'     upper edge, its lower edge and its depth.}
#'   \item{N-direction, T-direction}{Directions at right angles and parallel to the general course
#'     of the netting yarn (ISO 1107).}
#'   \item{orientation}{Direction of the meshes in a panel: diamond (T0), square (T45) or turned
#'     (T90).}
#'   \item{cutting rate}{Meshes lost or gained across a panel per mesh down it. For example, 1N2B
#'     alternates one point (N) and two bars (B) along the side edge. T is a mesh cut across; AN, AB
#'     and AT mean all points, all bars and all meshes (ISO 1532).}
#'   \item{take-up}{Ratio of mesh counts on two joined edges, such as 2:3.}
#'   \item{Rtex}{Resultant linear density of a twine: grams per kilometre.}
#'   \item{stretched length}{Length of netting with closed meshes: number of meshes times mesh
#'     size.}
#'   \item{hanging ratio}{Length of a rope divided by the stretched length of the netting hung on
#'     it.}
#'   \item{selvedge}{Strong netting, or an edge along which a panel is joined.}
#'   \item{seam}{Joint between the edges of panels. Joined edges share their points.}
#'   \item{solidity}{Projected area of twines and knots divided by the area of the netting.}
#' }
#' @section Gear:
#' \describe{
#'   \item{gear}{All parts in the water and their joints: netting, ropes and rigid pieces.}
#'   \item{kind}{Short form of plan for one type of gear, such as `bottom_trawl`.}
#'   \item{part}{Named component of the gear: a rope, a panel, a group of pieces, an otter board or
#'     a kite.}
#'   \item{warp}{Rope from the vessel to the otter board or to the net.}
#'   \item{otter board, door}{Board that spreads a trawl by its lift. Plans use `otter_board`;
#'     measures use the trade name, as in `door_spread_m`.}
#'   \item{backstrop}{Short rope from an otter board to the start of the sweep or the bridles.}
#'   \item{sweep, bridle, hand rope}{Ropes between board and net. A sweep is single. Bridles
#'     continue it to the wing tips. Hand ropes run from the board straight to the wing tips.}
#'   \item{headline, footrope}{Ropes along the upper and the lower edge of a net's mouth.}
#'   \item{bosom}{Middle part of the headline or footrope, between the wings.}
#'   \item{tickler}{Chain ahead of the footrope that disturbs the sea bed.}
#'   \item{ground gear}{Discs, bobbins or chain that protect the footrope and roll or slide over the
#'     sea bed.}
#'   \item{disc}{Rubber or steel disc on the wire of the ground gear. Bobbins and rollers count as
#'     discs.}
#'   \item{cover}{Netting laced over a section: a lifting bag, a chafer or a second layer.}
#'   \item{grid}{Bars in a rigid frame behind a section, which sort the catch ([sorting_grids]).}
#'   \item{float line, lead line}{Ropes with floats and with weights along the edges of a seine or
#'     gillnet.}
#'   \item{belly line, side line, cross rope}{Ropes that strengthen a net along its belly, along its
#'     side seams and around it.}
#'   \item{wing, square, section, codend}{Netting of a trawl, from front to rear.}
#'   \item{piece}{Rigid body at a point: a weight, a float, a hook or a ring.}
#'   \item{kite}{Rigid or canvas surface that lifts the headline. A depressor pulls down.}
#'   \item{purse wire}{Rope through the rings of a purse seine, which closes it from below.}
#'   \item{main line, branch line}{The long rope of a longline, and the short ropes on it that carry
#'     the hooks.}
#'   \item{basket}{Section of a longline between two float lines.}
#'   \item{demersal seine}{Net between two long ropes (seine ropes, its warps) on the sea bed. The
#'     ropes herd the fish while the vessel hauls them. A Danish seiner hauls at anchor; a Scottish
#'     seiner (fly dragging) tows at the same time.}
#'   \item{shooting, hauling}{Setting the gear from the vessel, and bringing it back.}
#' }
#' @section Plan and results:
#' \describe{
#'   \item{plan}{Description of a gear by its designer: the fields of a YAML file.}
#'   \item{schedule}{Inputs of a tow that change over time: speed, course, warps, current, catch.}
#'   \item{mesh of the model}{Nodes and elements that represent the gear; `state$mesh`.}
#'   \item{node}{Point of the model with a position and a velocity.}
#'   \item{element}{Component of the model that exerts forces on its nodes: a bar, a netting cell, a
#'     sphere or a rigid surface.}
#'   \item{bar}{Straight spring between two nodes with the drag of a cylinder. It represents one or
#'     many mesh bars, or a length of rope.}
#'   \item{cell}{Quadrilateral netting element that represents many meshes.}
#'   \item{state}{Positions, velocities, tensions and forces at one moment.}
#'   \item{settle}{To compute the static equilibrium of a gear in a steady flow.}
#'   \item{tow}{To compute the motion of a gear over time, with a schedule.}
#'   \item{trajectory}{Saved states of a tow, in order of time.}
#'   \item{snapshot}{One saved state of a trajectory.}
#'   \item{measure}{Number computed from a state, with a name, a unit and a definition.}
#'   \item{spread}{Horizontal distance across the tow, between boards or between wing ends.}
#' }
#' @section Forces and solution:
#' \describe{
#'   \item{drag, lift}{Components of the water's force along the relative velocity and at right
#'     angles to it.}
#'   \item{angle of attack}{Angle between a surface and the relative flow.}
#'   \item{heel, trim}{Rotation of a board about its chord, and about its normal.}
#'   \item{polar}{Lift and drag coefficients as functions of the angle of attack.}
#'   \item{added mass}{Mass of water that accelerates with a body.}
#'   \item{Morison-type drag}{Drag of netting as the sum of the forces on its twines (`morison`).}
#'   \item{screen drag model}{Drag and lift of netting from its solidity and its angle to the flow.}
#'   \item{wake, shielding}{A wake is the slowed water behind netting. Shielding is the reduction of
#'     drag on parts inside a wake.}
#'   \item{slack}{Without tension. Ropes and twines carry no compression.}
#'   \item{strength}{Breaking load of a rope.}
#'   \item{residual}{Net force on the free nodes; zero in equilibrium.}
#'   \item{mesh level}{One mesh in the sequence from coarse to fine that the solver uses.}
#'   \item{discretisation error}{Error from the finite number of nodes, see [measures()].}
#'   \item{scheme}{Formula for one step of the time integration, see [tow()].}
#' }
#' @seealso [measures()] for the definition of each measure; [settle()] and [tow()] for the methods;
#'   `vignette("get-started", "codend")`.
#' @examples
#' # the fields of a plan
#' names(read_gear("poly_noreastern_trawl")$plan)
#' @name glossary
NULL
