#' Summarise a gear
#'
#' Lists lengths, masses and weights in water of a gear's netting, ropes, otter boards and fittings.
#' Only the plan is needed; the gear is not settled.
#'
#' @param object A gear, from [read_gear()] or the constructors.
#' @param ... Not used.
#' @return A list of class `codend_gear_summary`:
#'
#'   - `name`, `kind` and `conditions` (strings);
#'   - `parts`: data frame, one row per role of ropes and pieces and per part of the net (see
#'     below);
#'   - `totals`: the masses and weights by `group`, and their sum;
#'   - `netting`: data frame, one row per panel (see below);
#'   - `findings`: warnings about the plan ([findings()]).
#'
#' @section Columns of `parts`:
#' - `group`: `netting`, `ropes`, `otter boards` or `fittings`; `part`;
#' - `number` of panels, ropes or pieces;
#' - `length_m` of ropes or twine;
#' - `mass_kg`, in air;
#' - `weight_in_water_kN`, negative for parts that float.
#'
#' @section Columns of `netting`:
#' - `panel`, `part` and `material` (`""` if the plan gives numbers instead);
#' - `mesh_size_mm`, `twine_mm`, and `twines` (2 for double twine);
#' - `meshes` (approximate number) and `knots`;
#' - `twine_m`: length of twine in bars and knots, counted per single twine (see [netting]);
#' - `in_knots_percent`: percentage of this length in knots;
#' - `twine_area_m2`: projected area of the bars, diameter times length;
#' - `mass_kg` and `weight_in_water_kN`.
#'
#' @seealso [findings()], [summary()][summary.codend_state] for a settled gear,
#'   [plot()][plot.codend_gear] for a drawing.
#' @examples
#' summary(read_gear("midwater_trawl"))
#' found <- summary(read_gear("t90_codend"))
#' found$netting[c("panel", "twine_m", "in_knots_percent", "mass_kg")]
#' @export
summary.codend_gear <- function(object, ...) {
  si <- gear_si(object)
  netting <- netting_table(si)
  parts <- gear_parts(si, netting)
  structure(
    list(
      name = object$plan$name, kind = gear_checked(object)$fields$kind,
      conditions = conditions_text(si, object$plan), parts = parts, totals = part_totals(parts),
      netting = netting, findings = findings(object)
    ),
    class = "codend_gear_summary"
  )
}

# Returns the table of parts: one row per part of the net and per role of ropes and pieces. netting:
# result of `netting_table()`.
gear_parts <- function(si, netting) {
  named <- function(role, name) ifelse(is.na(role) | !nzchar(role), name, gsub("_", " ", role))
  rows <- function(group, part, number, length, mass, weight) {
    sums <- rowsum(cbind(number, length, mass, weight), factor(part, unique(part)))
    colnames(sums) <- c("number", "length_m", "mass_kg", "weight_in_water_kN")
    data.frame(group = group, part = rownames(sums), sums, row.names = NULL)
  }
  of_items <- function(items, group, number = 1, per = "") {
    if (!length(items)) return(NULL)
    of <- function(field) vapply(items, function(item) item[[field]], 0, USE.NAMES = FALSE)
    amount <- if (nzchar(per)) of("length") else number
    mass <- amount * of(paste0("mass", per))
    excess <- mass - si$water$density * amount * of(paste0("volume", per))
    role <- vapply(items, function(item) first_of(item$role, NA_character_), "")
    rows(group, named(role, names(items)), number, if (nzchar(per)) amount else NA, mass,
      in_unit(gear_gravity * excess, "kN"))
  }
  number <- vapply(si$pieces, function(piece) as.double(piece$number), 0)
  is_board <- vapply(si$pieces, function(piece) piece$role %in% "otter_board", NA)
  rbind(
    if (nrow(netting)) {
      rows("netting", named(netting$part, netting$panel), 1, netting$twine_m, netting$mass_kg,
        netting$weight_in_water_kN)
    },
    of_items(si$ropes, "ropes", per = "_per_length"),
    of_items(si$otter_boards, "otter boards"),
    of_items(si$pieces[is_board], "otter boards", number[is_board]),
    of_items(si$pieces[!is_board], "fittings", number[!is_board])
  )
}

part_totals <- function(parts) {
  amounts <- parts[c("mass_kg", "weight_in_water_kN")]
  sums <- rowsum(as.matrix(amounts), factor(parts$group, unique(parts$group)))
  total <- rbind(sums, total = colSums(amounts))
  data.frame(group = rownames(total), total, row.names = NULL)
}

#' @rdname summary.codend_gear
#' @param x A summary.
#' @param n Largest number of printed lines. `Inf` prints all parts and warnings.
#' @export
print.codend_gear_summary <- function(x, n = 30, ...) {
  parts <- x$parts
  amounts <- function(table) {
    list(printed_figures(table$mass_kg, "kg"), printed_figures(table$weight_in_water_kN, "kN"))
  }
  none <- rep("", nrow(x$totals))
  lines <- align_columns(Map(c,
    list("", "number", paste("length", printed_unit("m")), paste("mass", printed_unit("kg")),
      paste("weight in water", printed_unit("kN"))),
    c(
      list(parts$part, format(parts$number),
        ifelse(is.na(parts$length_m), "", printed_figures(parts$length_m, "m"))),
      amounts(parts)
    ),
    c(list(x$totals$group, none, none), amounts(x$totals))
  ))
  totals <- utils::tail(lines, nrow(x$totals))
  warnings <- if (nrow(x$findings)) {
    found <- finding_lines(x$findings)
    c("", bold("Warnings"), if (is.finite(n)) limited_lines(found, 9) else found)
  }
  rows <- limited_lines(lines[1L + seq_len(nrow(parts))],
    n - 5L - length(totals) - length(warnings))
  cat(bold(x$name), paste0(x$kind, "; ", x$conditions), "", lines[1L], rows, "", totals, warnings,
    sep = "\n")
  invisible(x)
}
