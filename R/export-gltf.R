# Writes a state or trajectory as a glTF 2.0 scene. write: write_glb or write_gltf_text; colours:
# "tension" or "part". Returns `file`, invisibly.
write_gltf <- function(x, file, write, colours = c("tension", "part")) {
  colours <- chosen(colours, c("tension", "part"))
  write_file(file, function(path) {
    buffer <- gltf_buffer(dirname(file))
    on.exit(buffer$remove())
    scene <- with_plain_numbers(gltf_scene(gltf_moments(x), colours, buffer))
    with_plain_numbers(write(path, scene, buffer))
  })
}

# Maximum number of saved times in an animation.
gltf_times <- 60L

gltf_moments <- function(x) {
  if (inherits(x, "codend_state")) return(list(x))
  lapply(x$time[evenly(length(x$time), gltf_times)], function(time) state_at(x, time))
}

# Returns the glTF tree of a scene without its buffer; numbers go to the buffer part by part.
# moments: states of the same mesh. Viewers without animation show the first.
gltf_scene <- function(moments, colours, buffer) {
  state <- moments[[1L]]
  last <- moments[[length(moments)]]
  parts <- state$mesh$parts
  drawings <- lapply(moments, state_drawing, .Machine$integer.max)
  drawing <- drawings[[1L]]
  scales <- list(
    rope = tension_scale(drawing$ropes$tension, "rope"),
    netting = tension_scale(drawing$netting$tension, "netting")
  )
  one_each <- rep_len(series_palette, nrow(parts))
  meshes <- list()
  nodes <- list()
  add_mesh <- function(name, primitives) {
    meshes[[length(meshes) + 1L]] <<- list(name = name, primitives = primitives)
    length(meshes) - 1L
  }
  add_node <- function(...) {
    nodes[[length(nodes) + 1L]] <<- list(...)
    length(nodes) - 1L
  }
  motion <- gltf_motion(moments, buffer)
  corners <- lapply(moments, board_corners)
  balls <- lapply(drawings, function(one) gltf_balls(state, one$marks))
  places_of <- function(mine) rbind(mine$x, mine$y, mine$z)
  first_balls <- balls[[1L]]
  used <- unique(first_balls$role)
  ball_mesh <- setNames(vapply(used, function(role) {
    add_mesh(paste("ball,", role), list(ball_primitive(symbol_of(role)$fill, buffer)))
  }, 0), used)
  children <- numeric()
  for (part in seq_len(nrow(parts))) {
    name <- parts$name[part]
    kind <- parts$kind[part]
    extras <- list(kind = kind, role = parts$role[part])
    extras <- extras[!is.na(extras)]
    if (kind %in% c("rope", "netting")) {
      group <- if (kind == "rope") "ropes" else "netting"
      lines <- part_lines(drawing[[group]], part)
      ends <- lapply(drawings, function(one) {
        own <- part_lines(one[[group]], part)
        as.vector(rbind(own$from, own$to))
      })
      coloured <- function(tension) {
        if (colours == "tension") return(tension_colours(scales[[kind]], tension))
        rep(one_each[part], length(tension))
      }
      primitives <- list(gltf_primitive(ends, coloured(lines$tension), 2L, buffer, gltf_lines,
        gltf_unlit))
      sheet <- which(state$mesh$cell_part == part)
      if (length(sheet)) {
        colour <- coloured(pmax(state$u_tension[sheet], state$v_tension[sheet]))
        primitives[[2L]] <- sheet_primitive(moments, sheet, colour, buffer)
      }
      if (!length(lines$tension)) next
      extras$largest_tension_N <- max(lines$tension)
      node <- add_node(name = name, mesh = add_mesh(name, primitives), extras = extras)
      motion$morph(node)
      children <- c(children, node)
    } else if (name %in% names(state$si$otter_boards)) {
      at <- 4L * (match(name, names(state$si$otter_boards)) - 1L) + 1:4
      plate <- lapply(corners, function(all) as.vector(all[, at[c(1L, 2L, 3L, 1L, 3L, 4L)]]))
      plate <- gltf_primitive(plate, symbol_of(parts$role[part])$fill, 6L, buffer, gltf_triangles,
        gltf_unlit)
      node <- add_node(name = name, mesh = add_mesh(name, list(plate)), extras = extras)
      motion$morph(node)
      children <- c(children, node)
    } else {
      mine <- first_balls[first_balls$part == name, ]
      if (!nrow(mine)) next
      at <- lapply(balls, function(all) places_of(all[all$part == name, ]))
      inside <- vapply(seq_len(nrow(mine)), function(k) {
        node <- add_node(
          name = paste(name, k), mesh = ball_mesh[[mine$role[k]]],
          translation = at[[1L]][, k], scale = rep(mine$height[k] / 2, 3L)
        )
        motion$carry(node, vapply(at, function(places) places[, k], numeric(3)))
        node
      }, 0)
      children <- c(children, add_node(name = name, children = I(inside), extras = extras))
    }
  }
  quarter <- sqrt(0.5)
  top <- add_node(
    name = state$gear$plan$name, rotation = c(-quarter, 0, 0, quarter), children = I(children)
  )
  scene <- list(
    asset = list(
      version = "2.0", generator = paste("codend", utils::packageVersion("codend"))
    ),
    extensionsUsed = I("KHR_materials_unlit"),
    scene = 0L,
    scenes = list(list(
      name = state$gear$plan$name, nodes = I(top),
      extras = list(
        conditions = state_conditions(last), measures = as.list(measures(last)),
        axes = "below the top node: x aft, y to starboard, z up from the water surface, metres"
      )
    )),
    nodes = nodes, meshes = meshes, materials = gltf_materials()
  )
  played <- motion$animation()
  if (length(played)) scene$animations <- list(played)
  scene
}

# Returns the animation of moments as a list of functions. `morph(node)`: animates a mesh with a
# target per later moment. `carry(node, places)`: moves a node. `animation()`: returns the tree,
# NULL for a single moment.
gltf_motion <- function(moments, buffer) {
  n <- length(moments)
  none <- function(...) invisible()
  if (n < 2L) return(list(morph = none, carry = none, animation = function() NULL))
  times <- vapply(moments, `[[`, 0, "time")
  input <- buffer$add_track(times - times[1L])
  samplers <- list(list(
    input = input, interpolation = "LINEAR",
    # The first moment uses no target, each later moment only its own.
    output = buffer$add_track(as.double(cbind(0, diag(n - 1L))))
  ))
  channels <- list()
  add_channel <- function(node, path, sampler) {
    channels[[length(channels) + 1L]] <<- list(
      sampler = sampler, target = list(node = node, path = path)
    )
  }
  list(
    morph = function(node) add_channel(node, "weights", 0L),
    carry = function(node, places) {
      samplers[[length(samplers) + 1L]] <<- list(
        input = input, interpolation = "LINEAR", output = buffer$add_track(places)
      )
      add_channel(node, "translation", length(samplers) - 1L)
    },
    animation = function() list(name = "tow", samplers = samplers, channels = channels)
  )
}

# Adds a primitive: positions at every moment (x, y, z of each point in sequence), absolute at the
# first moment and as differences from it at later moments, and a colour for each line or sheet with
# `corners` points.
gltf_primitive <- function(places, colour, corners, buffer, mode, material, opacity = 1) {
  targets <- lapply(places[-1L], function(later) {
    list(POSITION = buffer$add_places(later - places[[1L]]))
  })
  c(
    list(attributes = list(
      POSITION = buffer$add_places(places[[1L]]),
      COLOR_0 = buffer$add_colours(rep(colour, each = corners), opacity)
    )),
    if (length(targets)) list(targets = targets),
    list(mode = mode, material = material)
  )
}

part_lines <- function(lines, part) {
  mine <- which(lines$part == part)
  list(
    from = lines$from[, mine, drop = FALSE], to = lines$to[, mine, drop = FALSE],
    tension = lines$tension[mine]
  )
}

# Returns the marks of pieces with their height (m). Boards have plates, and supports are not
# pieces.
gltf_balls <- function(state, marks) {
  height <- vapply(state$si$pieces, `[[`, 0, "height")
  if (!length(height)) return(data.frame(part = character(), role = character()))
  balls <- marks[marks$part %in% names(height) & !marks$role %in% c("moved", "fixed"), ]
  balls$height <- height[balls$part]
  balls
}

gltf_unlit <- 0L
gltf_sheet <- 1L
gltf_lit <- 2L

gltf_materials <- function() {
  unlit <- list(KHR_materials_unlit = setNames(list(), character()))
  matt <- list(metallicFactor = 0, roughnessFactor = 0.9)
  list(
    list(name = "lines", pbrMetallicRoughness = matt, extensions = unlit),
    list(name = "sheets", pbrMetallicRoughness = matt, extensions = unlit, alphaMode = "BLEND",
      doubleSided = TRUE),
    list(name = "pieces", pbrMetallicRoughness = matt, doubleSided = TRUE)
  )
}

gltf_lines <- 1L
gltf_triangles <- 4L

sheet_opacity <- 0.3

sheet_primitive <- function(moments, cells, colour, buffer) {
  corner <- cell_corners(moments[[1L]]$mesh, cells)
  four <- which(!has_three_corners(corner))
  node <- cbind(corner[1:3, , drop = FALSE], corner[c(1L, 3L, 4L), four, drop = FALSE])
  colour <- c(colour, colour[four])
  places <- lapply(moments, function(state) as.vector(state_points(state)[, node]))
  gltf_primitive(places, colour, 3L, buffer, gltf_triangles, gltf_sheet, sheet_opacity)
}

# Returns a sphere of radius 1: an octahedron with every face divided into four.
ball_primitive <- function(colour, buffer) {
  corner <- cbind(diag(3L), -diag(3L))
  faces <- rbind(
    c(1L, 2L, 4L, 5L, 2L, 4L, 5L, 1L), c(2L, 4L, 5L, 1L, 1L, 2L, 4L, 5L),
    c(3L, 3L, 3L, 3L, 6L, 6L, 6L, 6L)
  )
  unit <- function(x) x / rep(sqrt(colSums(x^2)), each = 3L)
  a <- corner[, faces[1L, ]]
  b <- corner[, faces[2L, ]]
  c <- corner[, faces[3L, ]]
  ab <- unit(a + b)
  bc <- unit(b + c)
  ca <- unit(c + a)
  places <- as.vector(rbind(a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca))
  list(
    attributes = list(
      POSITION = buffer$add_places(places), NORMAL = buffer$add_places(places),
      COLOR_0 = buffer$add_colours(rep(colour, length(places) / 3L))
    ),
    mode = gltf_triangles, material = gltf_lit
  )
}
