# Plots CPU seconds of a whole settle() against nodes on logarithmic axes, with exponents: SVG and
# PNG.

cost_colours <- c(
  trawl_bars = "#1b6ca8", trawl_cells = "#c8553d", panel_bars = "#3f8f5b",
  panel_cells = "#8a6fb0", own_trawl_bars = "#5f5f5f", own_trawl_cells = "#c79a2e"
)

# medians, exponents: results of summarise_runs() and fit_exponents().
save_cost_plot <- function(medians, exponents) {
  draw <- function() draw_costs(medians[medians$case %in% names(refined) & medians$settled > 0, ],
    exponents)
  save <- function(extension, device) {
    file <- file.path(results_folder, paste0("cost.", extension))
    codend:::write_file(file, function(path) {
      device(path)
      on.exit(grDevices::dev.off())
      draw()
    })
  }
  save("svg", function(path) grDevices::svg(path, width = 7, height = 5))
  save("png", function(path) grDevices::png(path, width = 7, height = 5, units = "in", res = 150,
    type = "cairo"))
}

draw_costs <- function(medians, exponents) {
  graphics::par(mar = c(4, 4.6, 0.8, 0.8), las = 1, mgp = c(2.6, 0.6, 0), tcl = -0.3)
  across <- range(medians$nodes) * c(0.8, 1.25)
  up <- range(c(medians$settle_least, medians$settle_most)) * c(0.6, 1.7)
  graphics::plot(NA, xlim = across, ylim = up, log = "xy", axes = FALSE, xlab = "nodes", ylab = "")
  graphics::title(ylab = "CPU seconds of settle()", mgp = c(3.4, 0.6, 0))
  # 1, 2 and 5 of every decade
  ticks <- function(range) {
    decades <- 10^seq(floor(log10(range[1])), ceiling(log10(range[2])))
    sort(c(decades, 2 * decades, 5 * decades))
  }
  plain <- function(x) format(x, scientific = FALSE, big.mark = ",", drop0trailing = TRUE,
    trim = TRUE)
  graphics::abline(v = ticks(across), h = ticks(up), col = "grey90")
  graphics::axis(1, ticks(across), vapply(ticks(across), plain, ""))
  graphics::axis(2, ticks(up), vapply(ticks(up), plain, ""))
  graphics::box(col = "grey60")
  for (case in unique(medians$case)) {
    of <- medians[medians$case == case, ]
    colour <- cost_colours[[case]]
    graphics::segments(of$nodes, of$settle_least, of$nodes, of$settle_most, col = colour)
    graphics::lines(of$nodes, of$settle, col = colour, lwd = 2)
    graphics::points(of$nodes, of$settle, col = colour, pch = 19)
  }
  cases <- unique(medians$case)
  slope <- exponents$settle[match(cases, exponents$case)]
  words <- vapply(cases, function(case) known_cases[[case]]$label, "")
  words <- paste0(words, ifelse(is.na(slope), "", sprintf(": n^%.2f", slope)))
  graphics::legend("topleft", words, col = cost_colours[cases], lwd = 2, pch = 19, bty = "n",
    inset = 0.01)
}
