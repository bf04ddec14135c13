# The legends of the 3D page, as HTML laid over the scene; the mouse reaches the scene through them.

# conditions: words below the name; bottom: room left below, pixels.
page_legend <- function(state, drawing, scales, conditions = state_conditions(state),
                        bottom = 12) {
  text <- "font: 12px/1.35 system-ui, sans-serif; color: #202428; pointer-events: none;"
  paste0(
    "<div class='view-title' style='position: absolute; left: 14px; top: 10px; ", text, "'>",
    "<div style='font-size: 17px; font-weight: 600'>", escape_markup(state$gear$plan$name),
    "</div>",
    "<div>", escape_markup(conditions), "</div></div>",
    "<div class='view-legend' style='position: absolute; left: 14px; bottom: ", bottom, "px; ",
    text,
    " display: flex; flex-wrap: wrap; gap: 26px; align-items: flex-start'>",
    html_colour_bar(scales$rope, "rope", slack_words(drawing$ropes$tension)),
    html_colour_bar(scales$netting, "netting", slack_words(drawing$netting$tension)),
    html_key(drawing$marks), "</div>"
  )
}

html_colour_bar <- function(scale, kind, slack) {
  heading <- paste0(
    "<div><div style='font-weight: 600; margin-bottom: 3px'>", scale_heading(scale, kind), "</div>",
    "<div style='display: flex; gap: 16px'>",
    if (length(slack)) {
      sprintf("<div><div style='width: 26px; height: 12px; background: %s'></div>%s</div>",
        slack_colour, slack)
    }
  )
  if (is.null(scale)) return(if (length(slack)) paste0(heading, "</div></div>") else "")
  colours <- scale$colours[round(seq(1, length(scale$colours), length.out = 16L))]
  at <- 100 * scale_share(scale, scale$ticks * scale$per_unit)
  ticks <- sprintf(
    "<span style='position: absolute; left: %.1f%%; transform: translateX(-50%%)'>%s</span>",
    at, tick_labels(scale)
  )
  paste0(
    heading,
    "<div style='width: 220px'><div style='height: 12px; background: linear-gradient(to right, ",
    paste(colours, collapse = ", "), ")'></div><div style='position: relative; height: 16px'>",
    paste(ticks, collapse = ""), "</div></div></div></div>"
  )
}

html_key <- function(marks) {
  used <- symbols_used(marks)
  if (!nrow(used)) return("")
  round <- ifelse(used$plate, "0", "50%")
  paste0(
    "<div style='display: grid; grid-template-columns: auto auto; gap: 1px 16px'>",
    paste0(
      sprintf(
        "<div><span style='display: inline-block; width: 9px; height: 9px; margin-right: 6px;
        background: %s; border: 1px solid #202428; border-radius: %s'></span>%s</div>",
        used$fill, round, used$label
      ),
      collapse = ""
    ),
    "</div>"
  )
}
