# What ParaView makes of the XML for the help, finished: cmake -DHELP=DIRECTORY -P FinishHelp.cmake
# Each page begins with a picture and with the way to the guide. The guide lists what there is, so
# that ParaView's own lists and the pages of classes inside are not needed.
file(GLOB superfluous "${HELP}/Readers.html" "${HELP}/Writers.html" "${HELP}/internal_*.html")
if (superfluous)
  file(REMOVE ${superfluous})
endif ()

set(pictures
  "filters.DirectionField=degrees"
  "filters.DirectionFieldGlyphs=glyphs"
  "filters.DirectionFieldStreamlines=lines"
  "filters.StripePattern=stripes"
  "filters.EditSingularities=editing"
  "filters.GuidanceFromCurves=curves"
  "filters.CompareDirectionFields=comparison"
  "filters.ReadDirectionField=files"
  "filters.FieldAlignedRemesh=remesh"
  "sources.DirectionFieldFile=files"
  "sources.SurfaceStrokes=curves"
  "filters.ShadedSurface=degrees"
  "writers.DirectionFieldWriter=files"
  "writers.AbaqusMeshWriter=remesh")
file(GLOB pages RELATIVE "${HELP}" "${HELP}/filters.*.html" "${HELP}/sources.*.html"
  "${HELP}/writers.*.html")
foreach (page IN LISTS pages)
  string(REGEX REPLACE "\\.html$" "" name "${page}")
  string(REGEX MATCH "${name}=([a-z]+)" found "${pictures}")
  if (NOT found)
    message(FATAL_ERROR "FinishHelp.cmake has no picture for the page ${page}.")
  endif ()
  set(picture "${CMAKE_MATCH_1}.png")
  file(READ "${HELP}/${page}" text)
  string(REGEX REPLACE "(<h2>[^<]*</h2>)" "\\1
<p><img src=\"${picture}\" alt=\"\"/></p>
<p><a href=\"index.html\">Guide to direction fields</a>, with pictures of all filters</p>"
    text "${text}")
  file(WRITE "${HELP}/${page}" "${text}")
endforeach ()
