test_that("text widths equal the widths of the PDF device", {
  grDevices::pdf(NULL, family = "Helvetica", useKerning = FALSE)
  on.exit(grDevices::dev.off())
  # the device counts in inches; text of 12 points has capitals of 0.718 times that
  size <- 12 * 25.4 / 72 * capital_height
  texts <- c("1N2B", "wing, bosom: 9.85 + 7.50", "Poly Nor'Eastern", "R 7680 tex PE", "\u00d8 23")
  for (bold in c(FALSE, TRUE)) {
    drawn <- graphics::strwidth(texts, "inches", font = 1L + bold) * 25.4
    # including the device's kerning, a few hundredths of the size
    expect_equal(text_width(texts, size, bold), drawn, tolerance = 0.02)
  }
})

test_that("SVG of a sheet has its marks in millimetres from the top", {
  sheet <- new_sheet(c(100, 50))
  on_sheet(sheet, component = "rope", ref = "ropes.warp", draw = {
    sheet_line(sheet, c(10, 20), c(5, 10))
    sheet_text(sheet, 30, 40, "a < b & \"c\"", 1.8)
  })
  on_sheet(sheet, component = "frame", draw = sheet_circle(sheet, 50, 25, 3))
  svg <- xml2::xml_ns_strip(xml2::read_xml(paste(sheet_svg(sheet, "T"), collapse = "\n")))
  groups <- xml2::xml_find_all(svg, "//g")
  expect_identical(xml2::xml_attr(groups, "data-path"), c("ropes.warp", NA))
  expect_identical(xml2::xml_attr(groups, "data-component"), c("rope", "frame"))
  expect_identical(xml2::xml_attr(xml2::xml_find_first(svg, "//polyline"), "points"), "10,45 20,40")
  text <- xml2::xml_find_first(svg, "//text")
  expect_identical(xml2::xml_text(text), "a < b & \"c\"")
  # the baseline is half of a capital below the middle
  expect_equal(as.double(xml2::xml_attr(text, "y")), 50 - 40 + 0.9)
  expect_identical(xml2::xml_attr(xml2::xml_find_first(svg, "//circle"), "cy"), "25")
})

svg_of <- function(gear) xml2::xml_ns_strip(xml2::read_xml(drawing_svg(gear)))

test_that("drawing names a plan field with its value for every figure", {
  for (name in c("midwater_trawl", "poly_noreastern_trawl", "gillnet", "flat_panel")) {
    gear <- read_gear(name)
    svg <- svg_of(gear)
    paths <- unique(xml2::xml_attr(xml2::xml_find_all(svg, "//g[@data-path]"), "data-path"))
    expect_gt(length(paths), 5)
    for (path in paths) expect_false(is.null(path_node(gear$plan, path)), label = path)
    sizes <- xml2::xml_find_all(svg, "//g[@data-component='mesh_size' and @data-path]")
    expect_gt(length(sizes), 0)
    for (size in sizes) {
      given <- plan_field(gear$plan, xml2::xml_attr(size, "data-path"))$value
      shown <- as.double(sub(" mm", "", xml2::xml_text(size), fixed = TRUE))
      expect_equal(shown / 1000, quantity_si(given, "length"))
    }
  }
})

test_that("path_finder() maps panels of a trawl to sections and wings", {
  find <- path_finder(read_gear("poly_noreastern_trawl"))
  expect_identical(find("panels.back_body.mesh_size"), "sections.body.mesh_size")
  expect_identical(find("panels.belly_body.twine.diameter"), "sections.body.belly.twine.diameter")
  expect_identical(find("panels.side_port_body.meshes.lower"), "sections.body.side.meshes.lower")
  expect_identical(find("panels.belly_wing_left.meshes.upper"), "wings.lower.meshes.tip")
  expect_identical(find("panels.back_wing_right"), "wings.upper")
  expect_identical(find("ropes.bridle_middle_port.length"), "bridles.middle.length")
  expect_identical(find("ropes.headline"), "headline")
  expect_identical(find("otter_boards.none"), "")
})

test_that("DXF has the gear's size and is readable by ezdxf", {
  sheet <- new_sheet(c(100, 50))
  sheet$scale <- 200
  on_sheet(sheet, component = "panel", layer = "NETTING",
    draw = sheet_polygon(sheet, c(10, 20, 20), c(10, 10, 30)))
  on_sheet(sheet, component = "rope", layer = "ROPES",
    draw = sheet_line(sheet, c(0, 1), c(0, 0), dash = c(3, 1)))
  sheet_text(sheet, 5, 5, "\u00d8 23 \u00e9 %%", 2)
  file <- file.path(test_folder(), "a.dxf")
  write_dxf(sheet, file)
  lines <- readLines(file, encoding = "latin1")
  expect_identical(length(lines) %% 2L, 0L)
  vertices <- which(lines == "VERTEX")
  # each x is four lines below: layer, code 10, value
  expect_equal(as.double(lines[vertices + 4L]), c(10, 20, 20) * 200)
  # the extent's x and y: code and value each
  expect_equal(as.double(lines[which(lines == "$EXTMAX") + c(2L, 4L)]), c(100, 50) * 200)
  # Debian: python3-ezdxf
  python <- "/usr/bin/python3"
  imported <- file.exists(python) && system2(python, c("-c", "'import ezdxf'"), FALSE, FALSE) == 0L
  skip_if_not(imported, "ezdxf for Python is not installed")
  said <- system2(python, c("-c", shQuote(paste(
    "import sys, ezdxf", "d = ezdxf.readfile(sys.argv[1])", "a = d.audit()",
    "print(len(a.errors), d.dxfversion)",
    "print([(e.dxftype(), e.dxf.layer) for e in d.modelspace()])",
    "print([e.plain_text() for e in d.modelspace().query(\"TEXT\")])",
    "print(max(v.dxf.location.y for p in d.modelspace().query(\"POLYLINE\") for v in p.vertices))",
    sep = "\n"
  )), file), stdout = TRUE)
  expect_identical(said, c(
    "0 AC1009", "[('POLYLINE', 'NETTING'), ('LINE', 'ROPES'), ('TEXT', 'SHEET')]",
    "['\u00d8 23 \u00e9 % %']", "6000.0"
  ))
})
