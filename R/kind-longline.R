# Pelagic longline (short form).
#
# The longline runs along x. Every float carries a float line, and the main line connects the lower
# ends of two neighbouring float lines (a basket). Branch lines hang from it at equal distances; n
# branch lines divide a basket into n + 1 stretches of main line.

expand_longline <- function(fields, plan) {
  check_longline(fields)
  baskets <- fields$baskets
  number <- fields$branch_lines$number
  apart <- fields$shortening_ratio * fields$main_line$length
  drift <- fields$floats$held == "ends"
  points <- ropes <- pieces <- list()
  main <- plan$main_line[setdiff(names(plan$main_line), "length")]
  main$length <- fields$main_line$length / (number + 1)
  branch <- plan$branch_lines[setdiff(names(plan$branch_lines), "number")]
  float <- plan$floats[setdiff(names(plan$floats), "held")]
  for (k in seq_len(baskets + 1)) {
    surface <- paste0("surface_", k)
    join <- paste0("join_", k)
    position <- list((k - 1) * apart, 0, 0)
    ends <- k %in% c(1, baskets + 1)
    mooring <- drift && ends && !is.null(plan$end_lines)
    held <- !drift || (ends && !mooring)
    points[[surface]] <- if (held) list(position = position, held = "fixed") else nothing
    points[[join]] <- nothing
    ropes[[paste0("float_line_", k)]] <-
      rope_between(surface, join, plan$float_lines, "float_line")
    if (drift) {
      pieces[[paste0("float_", k)]] <- c(list(at = surface), float, list(role = "float"))
    }
    if (mooring) {
      side <- if (k == 1) -1 else 1
      end <- if (k == 1) "first" else "last"
      points[[paste0("end_", end)]] <- list(
        position = list(position[[1]] + side * fields$end_lines$length, 0, 0), held = "fixed"
      )
      ropes[[paste0("end_line_", end)]] <-
        rope_between(paste0("end_", end), surface, plan$end_lines, "end_line")
    }
  }
  for (k in seq_len(baskets)) {
    on_main <- paste0("branch_", k, "_", seq_len(number))
    along <- c(paste0("join_", k), on_main, paste0("join_", k + 1))
    for (j in seq_len(number + 1)) {
      ropes[[paste0("main_line_", k, "_", j)]] <-
        rope_between(along[j], along[j + 1], main, "main_line")
    }
    for (j in seq_len(number)) {
      name <- paste0("branch_line_", k, "_", j)
      tip <- paste0("tip_", k, "_", j)
      points[[on_main[j]]] <- points[[tip]] <- nothing
      ropes[[name]] <- rope_between(on_main[j], tip, branch, "branch_line")
      pieces[[paste0("hook_", k, "_", j)]] <- part_with_role(plan$hooks, "hook", at = tip)
    }
  }

  out <- shared_fields(plan, fields)
  if (drift) out$water$free_surface <- TRUE
  out$points <- points
  out$ropes <- ropes
  out$pieces <- pieces
  out$measures <- longline_measures(baskets, number, drift)
  out
}

most_branch_lines <- 3000

check_longline <- function(fields) {
  branch_lines <- fields$baskets * fields$branch_lines$number
  if (branch_lines > most_branch_lines) {
    most <- most_branch_lines %/% fields$branch_lines$number
    abort_field("baskets", fields$baskets,
      paste("at most", most, "with this number of branch lines per basket"))
  }
  if (fields$floats$held == "ends") {
    float <- fields$floats[setdiff(names(fields$floats), c("held", "added_mass"))]
    if (!length(float)) {
      abort_field("floats.buoyancy", NULL, "given if only the floats at the ends are held",
        "is missing")
    }
  } else if (!is.null(fields$end_lines)) {
    abort_field("end_lines", "given", "omitted if `floats.held` is all")
  }
}

# Measures of the middle basket, which has the smallest end effects.
longline_measures <- function(baskets, number, drift) {
  k <- (baskets + 1) %/% 2
  hooks <- seq_len(number)
  out <- stats::setNames(
    lapply(hooks, function(j) list(depth = paste0("branch_line_", k, "_", j, ".end"))),
    paste0("hook_", hooks, "_depth")
  )
  lowest <- paste0("main_line_", k, "_", number %/% 2 + 1, if (number %% 2) ".end" else ".middle")
  c(out, list(
    main_line_depth = list(depth = lowest),
    main_line_tension = list(tension = paste0("main_line_", k, "_1.start")),
    float_line_tension = list(tension = paste0("float_line_", k, ".start")),
    float_distance = list(length = paste0("surface_", c(k, k + 1)))
  ))
}
