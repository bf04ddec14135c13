# Writes the page of the book: tables and pictures of misfits by case and by quantity.

found_colours <- c(held = "#0072B2", missed = "#D55E00", tuned = "#999999")
found_marks <- c(held = 16, missed = 17, tuned = 1)

# Writes misfits.csv (a row per value), book.md and its pictures into a folder.
write_page <- function(rows, judged, manifest, folder) {
  figures <- file.path(folder, "figures")
  dir.create(figures, showWarnings = FALSE)
  picture <- function(name, width, height, draw) {
    file <- file.path(figures, paste0(name, ".png"))
    grDevices::png(file, width, height, units = "in", res = 110)
    on.exit(grDevices::dev.off())
    draw()
  }
  measured <- judged[judged$kind == "quantity" & !judged$group %in%
    c("exact", "motion", "coefficients"), ]
  picture("misfit-by-case", 9, 10.5, function() draw_misfits(measured, manifest))
  picture("misfit-by-quantity", 9, 4.2, function() draw_quantities(rows, manifest))
  picture("hauls-by-warp", 9, 8, function() draw_hauls(rows, manifest))
  picture("flume", 9, 4, function() draw_flume(rows))
  shown <- rows
  number <- vapply(shown, is.double, NA)
  shown[number] <- lapply(shown[number], signif, 10)
  write_lines(file.path(folder, "misfits.csv"), utils::capture.output(
    utils::write.csv(shown, row.names = FALSE)
  ))
  write_lines(file.path(folder, "book.md"), page_lines(judged, manifest))
  cat(page_summary(judged), sep = "\n")
}

write_lines <- function(file, lines) {
  draft <- paste0(file, ".part")
  writeLines(lines, draft)
  if (!file.rename(draft, file)) stop("cannot write ", file)
}

count_found <- function(judged, kind) {
  of <- judged$found[judged$kind == kind]
  table(factor(of, names(found_colours)))
}

page_summary <- function(judged) {
  of <- count_found(judged, "quantity")
  trends <- count_found(judged, "trend")
  trawls <- trawl_misfit(judged)
  c(
    sprintf("%d cases, %d quantities: %d held, %d missed, %d tuned, which do not count.",
      length(unique(judged$case)), sum(of), of[["held"]], of[["missed"]], of[["tuned"]]),
    sprintf("%d trends: %d have the sign that was measured, %d have not.", sum(trends),
      trends[["held"]], trends[["missed"]]),
    sprintf(paste("Trawls in the flume and at sea, geometry and tension, %d quantities that",
      "nothing is tuned on: %.1f %% off on the mean."), trawls[["quantities"]], trawls[["mean"]])
  )
}

page_lines <- function(judged, manifest) {
  quantities <- judged[judged$kind == "quantity", ]
  trends <- judged[judged$kind == "trend", ]
  missed <- judged[judged$found == "missed", ]
  tuned <- Filter(function(case) !is.null(case$tuned), manifest)
  c(
    "# The validation book", "",
    paste("What codend is held against, and how far off it is. `make validate` computes this page",
      "from [manifest.yaml](manifest.yaml); [README.md](README.md) tells how. Every value is in",
      "[misfits.csv](misfits.csv)."), "",
    paste("-", page_summary(judged)), "",
    paste("A quantity is **held** where the mean size of its misfits is within its band:",
      "the tolerance of what was measured, or what the division of the mesh leaves of a closed",
      "form. Misfits are in percent of what was measured. Nothing is tuned to a haul, a speed or a",
      "ship."), "",
    "![Misfit by case](figures/misfit-by-case.png)", "",
    "![Misfit by quantity](figures/misfit-by-quantity.png)", "",
    "## Hauls by warp", "",
    paste("A GOV 36/47 from published particulars ([plan](plans/gov_36_47.yaml)) with what",
      "each ship reports of boards, warps, floats and sweeps, the survey trawl of the Gulf of",
      "Alaska and a small midwater trawl: means of hauls (points) and codend (lines)."), "",
    "![Hauls by warp](figures/hauls-by-warp.png)", "",
    "## The flume of 2025", "",
    "How near any model can come, and what moves an opening: [openings.md](openings.md).", "",
    "![Flume tests](figures/flume.png)", "",
    unlist(lapply(names(case_groups), function(group) {
      of <- quantities[quantities$group == group, ]
      c(paste("##", case_groups[[group]]), "",
        "| case | quantity | values | mean misfit % | mean size % | largest % | band % | |",
        "|---|---|--:|--:|--:|--:|--:|---|",
        sprintf("| %s | %s | %d | %s | %s | %s | %s | %s |",
          title_of(of$case, manifest), with_spaces(of$quantity), of$values,
          percent(of$bias), percent(of$misfit), percent(of$largest), percent(of$band),
          ifelse(of$found == "missed", "**missed**", of$found)),
        "")
    })),
    "## Trends", "",
    paste("Slopes of the logarithm of a quantity by that of what was varied, as mean over the",
      "series of a case; where only a direction is published it is 1 or -1. **held**: all",
      "signs are right."),
    "",
    "| case | quantity | by | series | measured | codend | |", "|---|---|---|--:|--:|--:|---|",
    sprintf("| %s | %s | %s | %d | %.2f | %.2f | %s |", title_of(trends$case, manifest),
      with_spaces(trends$quantity), with_spaces(trends$by), trends$values,
      trends$measured, trends$computed,
      ifelse(trends$found == "missed", "**missed**", trends$found)), "",
    "## Why what is missed is missed", "",
    "| case | quantity | why |", "|---|---|---|",
    sprintf("| %s | %s | %s |", title_of(missed$case, manifest),
      paste0(with_spaces(missed$quantity), ifelse(missed$kind == "trend", ", trend", "")),
      missed$why),
    "",
    "## What is tuned on what", "",
    vapply(tuned, function(case) sprintf("- **%s.** %s", case$title, case$tuned), ""), "",
    "## Plans and sources", "",
    "| case | plan | held against |", "|---|---|---|",
    vapply(manifest, function(case) {
      sprintf("| %s | %s | %s |", case$title, case$plan, case$source)
    }, "")
  )
}

title_of <- function(ids, manifest) vapply(manifest[ids], function(case) case$title, "")
with_spaces <- function(name) gsub("_", " ", name)
percent <- function(x) {
  ifelse(abs(x) >= 0.095, sprintf("%.1f", x), formatC(x, 1, format = "g"))
}

# Mean misfit of every quantity by case, with its allowed range as a bar about zero.
draw_misfits <- function(judged, manifest) {
  n <- nrow(judged)
  old <- graphics::par(mar = c(4, 23, 2.5, 1), las = 1, cex = 0.75)
  on.exit(graphics::par(old))
  limit <- max(abs(judged$bias), judged$misfit) * 1.1
  plot(NULL, xlim = c(-limit, limit), ylim = c(n, 1), yaxt = "n", ylab = "",
    xlab = "mean misfit, % of measured (grey: band of the measurement; line: mean size of misfits)")
  graphics::abline(v = 0, col = "grey40")
  graphics::rect(-judged$band, seq_len(n) - 0.35, judged$band, seq_len(n) + 0.35, col = "grey88",
    border = NA)
  graphics::segments(-judged$misfit, seq_len(n), judged$misfit, seq_len(n), col = "grey45")
  graphics::points(judged$bias, seq_len(n), pch = found_marks[judged$found],
    col = found_colours[judged$found], cex = 1.3)
  first <- !duplicated(judged$case)
  graphics::abline(h = which(first)[-1] - 0.5, col = "grey80")
  graphics::axis(2, seq_len(n), with_spaces(judged$quantity), tick = FALSE, line = -0.8,
    cex.axis = 0.8)
  graphics::axis(2, which(first), abbreviate_title(title_of(judged$case[first], manifest)),
    tick = FALSE, line = 6.2, cex.axis = 0.85, font = 2)
  graphics::legend("top", names(found_colours), pch = found_marks, col = found_colours,
    horiz = TRUE, bty = "n", inset = c(0, -0.035), xpd = NA)
}

abbreviate_title <- function(title) sub("sweeps of |of the training ship ", "", title)

# Every value of trawls, by quantity.
draw_quantities <- function(rows, manifest) {
  group <- vapply(manifest[rows$case], function(case) case$group, "")
  names <- c("bridle_tension", "opening", "door_spread", "wing_spread", "lower_wing_spread",
    "middle_wing_spread", "wing_height", "bridle_angle", "drag")
  of <- rows[rows$kind == "quantity" & group %in% c("flume", "hauls") & !rows$tuned, ]
  stopifnot(of$quantity %in% names)
  group <- vapply(manifest[of$case], function(case) case$group, "")
  of$misfit <- 100 * (of$computed / of$measured - 1)
  old <- graphics::par(mar = c(4, 10, 1, 1), las = 1, cex = 0.8)
  on.exit(graphics::par(old))
  at <- match(of$quantity, names) + ifelse(group == "flume", -0.17, 0.17)
  plot(of$misfit, at, pch = ifelse(group == "flume", 1, 4), ylim = c(length(names) + 0.4, 0.6),
    col = ifelse(group == "flume", "#0072B2", "#D55E00"), yaxt = "n", ylab = "",
    xlab = "misfit of every value, % of measured (bars: means)")
  graphics::abline(v = 0, col = "grey40")
  graphics::abline(v = c(-10, 10), col = "grey80", lty = 2)
  for (key in unique(at)) {
    mean <- mean(of$misfit[at == key])
    graphics::segments(mean, key - 0.15, mean, key + 0.15, lwd = 3, col = "black")
  }
  graphics::axis(2, seq_along(names), with_spaces(names), tick = FALSE)
  graphics::legend("topleft", c("flume", "hauls"), pch = c(1, 4), col = c("#0072B2", "#D55E00"),
    bg = "white")
}

draw_hauls <- function(rows, manifest) {
  colours <- c(door_spread = "#0072B2", wing_spread = "#009E73", opening = "#D55E00")
  hauls <- names(Filter(function(case) case$group == "hauls", manifest))
  rows <- rows[rows$case %in% hauls & rows$kind == "quantity" & rows$quantity %in% names(colours) &
    grepl(" m of (warp|wire)$", rows$at), ]
  hauls <- intersect(hauls, rows$case)
  # the last picture is the legend
  old <- graphics::par(mfrow = c(ceiling((length(hauls) + 1) / 4), 4),
    mar = c(3.6, 3.2, 2, 0.8), mgp = c(2, 0.6, 0), las = 1)
  on.exit(graphics::par(old))
  for (id in hauls) {
    of <- rows[rows$case == id, ]
    of$warp <- as.numeric(sub(" m.*", "", of$at))
    of <- of[order(of$warp), ]
    plot(NULL, xlim = range(of$warp), ylim = c(2, 170), log = "y", xlab = "warp, m", ylab = "m",
      main = abbreviate_title(manifest[[id]]$title), cex.main = 0.9, yaxt = "n")
    graphics::axis(2, c(2, 3, 5, 10, 20, 50, 100, 150))
    graphics::grid(ny = NA)
    for (name in names(colours)) {
      own <- of[of$quantity == name, ]
      graphics::points(own$warp, own$measured, pch = 16, cex = 1.3, col = colours[[name]])
      graphics::lines(own$warp, own$computed, lwd = 2, col = colours[[name]])
    }
  }
  graphics::plot.new()
  graphics::legend("center", c("door spread", "wing spread", "opening"), col = colours, pch = 16,
    lwd = 2, bty = "n", cex = 1.2)
}

draw_flume <- function(rows) {
  old <- graphics::par(mfrow = c(1, 3), mar = c(4, 4, 2, 1), las = 1)
  on.exit(graphics::par(old))
  of <- rows[grepl("^flume", rows$case) & rows$kind == "quantity", ]
  labels <- c(bridle_tension = "bridle tension, both sides, t", opening = "headline height, m",
    lower_wing_spread = "spread of the lower wing ends, m")
  colours <- c(speed = "#000000", spread = "#0072B2", `split bridles` = "#D55E00",
    `pulling height` = "#009E73")
  varied <- c(flume_speed = 1, flume_spread = 2, flume_split_bridles = 3, flume_pulling_height = 4,
    flume_eastern_speed = 1, flume_eastern_narrow = 2, flume_eastern_split = 3,
    flume_eastern_pulling = 4)
  for (name in names(labels)) {
    own <- of[of$quantity == name, ]
    both <- range(own$measured, own$computed)
    plot(own$measured, own$computed, xlim = both, ylim = both, xlab = "flume", ylab = "codend",
      main = labels[[name]], col = colours[varied[own$case]],
      pch = ifelse(own$tuned, 1, ifelse(grepl("eastern", own$case), 17, 16)))
    graphics::abline(0, 1, col = "grey40")
    graphics::abline(0, 1.1, col = "grey75", lty = 2)
    graphics::abline(0, 0.9, col = "grey75", lty = 2)
  }
  graphics::legend("bottomright",
    c(names(colours), "tuned on", "83-112"), col = c(colours, "black", "black"),
    pch = c(16, 16, 16, 16, 1, 17), bty = "n")
}
