# Tests that the judge takes part in.
surefoot_test(judge_test judge_test.cpp)
surefoot_test(metamorphic_test metamorphic_test.cpp ${PROJECT_SOURCE_DIR}/tools/prove/lines.cpp)
surefoot_test(proof_test proof_test.cpp ${PROJECT_SOURCE_DIR}/tools/prove/lines.cpp)
surefoot_test(upright_start_test upright_start_test.cpp upright_zero_test.cpp)
surefoot_test(world_judged_test world_judged_test.cpp)
foreach(name judge_test metamorphic_test proof_test upright_start_test world_judged_test)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tools)
  target_link_libraries(${name} PRIVATE surefoot_judge)
endforeach()

# The sweeps once more, with the seeded faults that the judge must catch. Objects and no archive: all of them are linked,
# so that nothing asks the core's own library for a sweep. Never installed.
get_target_property(core_sources surefoot SOURCES)
list(FILTER core_sources INCLUDE REGEX "^sweep/")
list(TRANSFORM core_sources PREPEND ${PROJECT_SOURCE_DIR}/src/)
add_library(surefoot_faulty OBJECT EXCLUDE_FROM_ALL ${core_sources})
surefoot_target(surefoot_faulty)
target_include_directories(surefoot_faulty PUBLIC ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(surefoot_faulty PUBLIC surefoot::surefoot)
target_compile_definitions(surefoot_faulty PUBLIC SUREFOOT_SEEDED_FAULTS)

add_executable(faults_test faults_test.cpp)
surefoot_target(faults_test)
target_include_directories(faults_test PRIVATE ${PROJECT_SOURCE_DIR}/tools)
find_package(fmt REQUIRED)
target_link_libraries(faults_test PRIVATE surefoot_faulty surefoot_judge fmt::fmt GTest::gtest_main)
# One test for all: what is sound without faults is found out once.
add_test(NAME faults_test COMMAND faults_test)
