# Tables of forces for the print of a summary and for the report: columns of strings by heading.
# Headings of text columns begin with a space. Forces are in the unit of options(codend.units).

# Returns a column of forces with its heading.
force_column <- function(name, kilonewtons) {
  setNames(list(printed_figures(kilonewtons, "kN")), paste(name, printed_unit("kN")))
}

one_decimal <- function(x) ifelse(is.finite(x), formatC(x, format = "f", digits = 1), "")

# Groups a table by role, with names such as "warp, 2 ropes" or "cable".
by_role <- function(table) {
  name <- ifelse(is.na(table$role), table$part, gsub("_", " ", table$role))
  groups <- split(table, paste(table$kind, name))
  words <- c(rope = "ropes", netting = "panels", piece = "pieces")
  setNames(groups, vapply(groups, function(group) {
    n <- nrow(group)
    if (is.na(group$role[1])) return(group$part[1])
    paste0(gsub("_", " ", group$role[1]), if (n > 1) paste0(", ", n, " ", words[[group$kind[1]]]))
  }, ""))
}

# Returns the first groups of a table by role, sorted by falling `value`, a function of a group.
largest_groups <- function(table, value, most) {
  groups <- by_role(table)
  utils::head(groups[order(-vapply(groups, value, 0))], most)
}

# A row per role of ropes: the rope with the largest tension.
rope_columns <- function(ropes, most = Inf) {
  groups <- largest_groups(ropes, function(group) max(group$max_kN), most)
  highest <- do.call(rbind, lapply(groups, function(g) g[which.max(g$max_kN), ]))
  c(
    list(` rope` = names(groups), ` highest in` = gsub("_", " ", highest$part)),
    force_column("largest", highest$max_kN),
    list(`largest tonnes` = column_figures(highest$max_kN / 9.80665)),
    force_column("mean", highest$mean_kN),
    force_column("breaking load", highest$strength_kN),
    list(`used %` = one_decimal(highest$strength_percent),
      `safety factor` = one_decimal(highest$strength_kN / highest$max_kN))
  )
}

# A row per part of the net: tensions of one twine, and the percentage of slack twine.
netting_columns <- function(netting, slack, most = Inf) {
  groups <- largest_groups(netting, function(group) max(group$most_loaded_kN), most)
  newtons <- function(of) {
    column_figures(vapply(groups, function(group) from_unit(of(group), "kN"), 0,
      USE.NAMES = FALSE))
  }
  list(
    ` part` = names(groups), `mean N` = newtons(function(group) mean(group$mean_kN)),
    `most loaded tenth N` = newtons(function(group) max(group$most_loaded_kN)),
    `slack %` = one_decimal(vapply(groups, function(group) {
      own <- slack[match(group$part, slack$part), ]
      stats::weighted.mean(own$slack_percent, own$twine_m)
    }, 0, USE.NAMES = FALSE))
  )
}

drag_columns <- function(totals, names, heading = " group") {
  c(
    setNames(list(names), heading), force_column("drag", totals$drag_kN),
    list(`share %` = share_text(totals$drag_kN, totals$drag_kN[nrow(totals)])),
    force_column("side", totals$side_kN), force_column("lift", totals$lift_kN),
    force_column("weight in water", totals$weight_in_water_kN)
  )
}

# A row per role, with the largest drag first, and rows of the other roles and of all; NULL for a
# gear of one role.
drag_part_columns <- function(drag, totals, most) {
  groups <- by_role(drag)
  forces <- c("drag_kN", "side_kN", "lift_kN", "weight_in_water_kN")
  sums <- list2DF(lapply(setNames(nm = forces), function(force) {
    vapply(groups, function(group) sum(group[[force]]), 0)
  }))
  first <- utils::head(order(-sums$drag_kN), most)
  first <- first[sums$drag_kN[first] > 0]
  if (length(first) < 2L) return(NULL)
  others <- colSums(sums[-first, , drop = FALSE])
  rows <- rbind(sums[first, ], if (any(others != 0)) as.list(others), totals[nrow(totals), forces])
  names <- c(gsub("_", " ", names(groups)[first]), if (any(others != 0)) "other parts", "total")
  drag_columns(rows, names, " part")
}

board_columns <- function(boards) {
  c(
    list(` board` = gsub("_", " ", boards$board), `attack deg` = column_figures(boards$attack_deg),
      `largest lift at deg` = column_figures(boards$stall_deg),
      `heel deg` = column_figures(boards$heel_deg), `trim deg` = column_figures(boards$trim_deg)),
    force_column("lift", boards$lift_kN), force_column("drag", boards$drag_kN),
    force_column("load on the sea bed", boards$ground_load_kN),
    list(` condition` = boards$condition)
  )
}

# `name`: column of the table with the names of its rows.
axis_columns <- function(table, name, heading) {
  c(
    setNames(list(gsub("_", " ", table[[name]])), heading), force_column("x (aft)", table$x_kN),
    force_column("y (starboard)", table$y_kN), force_column("z (up)", table$z_kN)
  )
}

# The remainder is much smaller than the forces, so it has scientific notation.
balance_columns <- function(balance) {
  last <- balance$force == "remainder"
  columns <- axis_columns(balance[!last, ], "force", " force")
  left <- in_unit(from_unit(unlist(balance[last, -1L]), "kN"), printed_unit("kN"))
  Map(c, columns, c("remainder", formatC(left, format = "e", digits = 1)))
}
