# cmake -DCHECK=file -DWORK=folder -P self_test.cmake: the check fails where it must and only there.
cmake_minimum_required(VERSION 3.25)
file(MAKE_DIRECTORY ${WORK})

# expect(OUTCOME BASE COUNTS [BUILD]): OUTCOME is a text that the check must print, `fails` or `passes` before it.
function(expect outcome text base counts build)
  file(WRITE ${WORK}/base.txt "${base}")
  file(WRITE ${WORK}/counts.txt "${counts}")
  execute_process(COMMAND ${CMAKE_COMMAND} -DBASE=${WORK}/base.txt -DCOUNTS=${WORK}/counts.txt -DBUILD=${build}
                          -P ${CHECK}
                  OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE code)
  if(code EQUAL 0)
    set(found passes)
  else()
    set(found fails)
  endif()
  if(NOT found STREQUAL outcome OR NOT out MATCHES "${text}")
    message(FATAL_ERROR "base '${base}', counts '${counts}': ${found}, not ${outcome} with '${text}':\n${out}")
  endif()
endfunction()

set(base "build X 1\nbuild_city 1000\ntrace 5000000000\n")
expect(passes "build_city: 1000 instructions" "${base}" "build_city 1000\ntrace 5000000000\n" "X 1")
expect(passes "build_city: 1100 instructions" "${base}" "build_city 1100\ntrace 5000000000\n" "X 1")
expect(fails "build_city: 1101 .*TOO MANY" "${base}" "build_city 1101\ntrace 5000000000\n" "X 1")
expect(fails "trace: 5500000001 .*TOO MANY" "${base}" "build_city 1000\ntrace 5500000001\n" "X 1")
expect(passes "better" "${base}" "build_city 800\ntrace 5000000000\n" "X 1")
expect(fails "trace: has a base" "${base}" "build_city 1000\n" "X 1")
expect(fails "stitch: has no base" "${base}" "build_city 1000\ntrace 5000000000\nstitch 1\n" "X 1")
expect(fails "nothing was counted" "${base}" "" "X 1")
expect(passes "skipped" "${base}" "build_city 9000\n" "X 2")
message("the check fails where it must")
