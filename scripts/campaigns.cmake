# The long tests of ./test --all, read by ctest itself beside the builds' own tests. Each is one line of the summary.
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}" DIRECTORY)

set(queries "$ENV{SUREFOOT_PROVE_QUERIES}")
if(NOT queries)
  set(queries 10000000)
endif()
foreach(shape IN ITEMS sphere ellipsoid capsule box cylinder cone)
  add_test(campaign.prove.${shape} "${root}/build/release/tools/surefoot" prove --shape ${shape} --queries ${queries})
  set_tests_properties(campaign.prove.${shape} PROPERTIES TIMEOUT 86400)
endforeach()

# The whole movement course with every shape, the broken mover that each of its scenes is about, and the page that tells.
foreach(shape IN ITEMS sphere ellipsoid capsule box cylinder cone)
  add_test(campaign.course.${shape} "${root}/build/release/tools/surefoot" course --shape ${shape})
  add_test(campaign.course_catches.${shape} "${root}/build/release/tools/surefoot" course --catches --shape ${shape})
endforeach()
add_test(campaign.course_page sh -c
  "'${root}/build/release/tools/surefoot' course --shape all --json | '${root}/scripts/course_table.py' --shapes --check -")

# Ten minutes of fuzzing in all: every target of build/fuzz gets its share.
set(seconds "$ENV{SUREFOOT_FUZZ_SECONDS}")
if(NOT seconds)
  set(seconds 600)
endif()
add_test(campaign.fuzz "${root}/scripts/fuzz.sh" ${seconds})
set_tests_properties(campaign.fuzz PROPERTIES TIMEOUT 86400)

add_test(campaign.clang_tidy "${root}/scripts/tidy.sh")
set_tests_properties(campaign.clang_tidy PROPERTIES TIMEOUT 86400)

add_test(campaign.platformer_agreement "${root}/build/release/tests/playtest/platformer_agreement_test")
set_tests_properties(campaign.platformer_agreement PROPERTIES TIMEOUT 3600
  ENVIRONMENT "SUREFOOT_IMPORTER=${root}/build/release/import/surefoot-importer")

# Hours of play in every level of the platformer: nobody stuck, out of it, or nowhere, whoever knows the way finishes, and
# explorers die in all of it rather than in one section.
set(hours "$ENV{SUREFOOT_PLAYTEST_HOURS}")
if(NOT hours)
  set(hours 2)
endif()
add_test(campaign.playtest "${root}/build/release/tools/surefoot" playtest "${root}/levels/platformer" --bots 8
  --hours ${hours} --report "${root}/out/playtest.html")
set_tests_properties(campaign.playtest PROPERTIES TIMEOUT 86400)
