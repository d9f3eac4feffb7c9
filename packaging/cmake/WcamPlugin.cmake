# SPDX-FileCopyrightText: 2026 The WCAM developers
# SPDX-License-Identifier: GPL-3.0-or-later
# Building WCAM plugins: in this tree, and in other projects after
# find_package(wcam COMPONENTS PluginSdk). See resources/doc/plugin-sdk.md.

# The package sets the ABI; this tree reads it from the header that defines it.
if(NOT DEFINED WCAM_PLUGIN_ABI)
  file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/../../engine/include/wcam/plugin/abi.h" abi_lines
    REGEX "^#define WCAM_PLUGIN_ABI_M[AI][JN]OR [0-9]+$")
  string(REGEX REPLACE "[^;]* ([0-9]+)" "\\1" abi_numbers "${abi_lines}")
  string(REPLACE ";" "." WCAM_PLUGIN_ABI "${abi_numbers}")
endif()
string(REGEX REPLACE "\\..*" "" WCAM_PLUGIN_ABI_MAJOR "${WCAM_PLUGIN_ABI}")

# Sets `output` to a quoted JSON string.
function(_wcam_json_text output text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  set(${output} "\"${text}\"" PARENT_SCOPE)
endfunction()

# wcam_add_plugin(target
#   ID com.acme.post.demo NAME "Demo post-processor" VERSION 1.0.0 VENDOR "Acme"
#   [LICENCE GPL-3.0-or-later]
#   SOURCES demo.cpp ...
#   COMPONENTS "post:com.acme.post.demo:Demo" ...      kind:id:name, kind = slicing or post
#   [LIBRARIES ...])
#
# Id and version are said here alone: WCAM_PLUGIN() takes them from the compiler's command line. Without a build
# type the library is optimised (Release). Builds <ID>.so and writes its manifest <ID>.json beside it, in WCAM_PLUGIN_OUTPUT_DIR. Default: within
# WCAM the plugin folder of the build tree; elsewhere <build>/wcam-plugins, which can be named in
# WCAM_PLUGIN_PATH. They are installed to WCAM_PLUGIN_INSTALL_DIR (default <libdir>/wcam/plugins/<ABI>);
# when that is set but empty they are not.
function(wcam_add_plugin target)
  cmake_parse_arguments(arg "" "ID;NAME;VERSION;VENDOR;LICENCE" "SOURCES;COMPONENTS;LIBRARIES" ${ARGN})
  foreach(required ID NAME VERSION SOURCES COMPONENTS)
    if(NOT arg_${required})
      message(FATAL_ERROR "wcam_add_plugin(${target}): ${required} is missing")
    endif()
  endforeach()
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "wcam_add_plugin(${target}): unknown arguments ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_VENDOR AND TARGET wcam_engine)
    set(arg_VENDOR "The WCAM developers")
  elseif(NOT arg_VENDOR)
    message(FATAL_ERROR "wcam_add_plugin(${target}): VENDOR is missing: who makes the plugin")
  endif()
  if(NOT arg_LICENCE)
    set(arg_LICENCE "GPL-3.0-or-later")
  endif()

  set(kinds "")
  set(components "")
  foreach(component IN LISTS arg_COMPONENTS)
    if(NOT component MATCHES "^(slicing|post):([a-z0-9_.-]+):(.+)$")
      message(FATAL_ERROR "wcam_add_plugin(${target}): '${component}' is not kind:id:name with kind slicing or post")
    endif()
    set(kind "${CMAKE_MATCH_1}")
    set(component_id "${CMAKE_MATCH_2}")
    _wcam_json_text(component_name "${CMAKE_MATCH_3}")
    list(APPEND kinds "\"${kind}\"")
    list(APPEND components
      "    {\n      \"id\": \"${component_id}\",\n      \"kind\": \"${kind}\",\n      \"name\": ${component_name}\n    }")
  endforeach()
  list(REMOVE_DUPLICATES kinds)
  list(JOIN kinds ", " kinds)
  list(JOIN components ",\n" components)
  foreach(field ID NAME VERSION VENDOR LICENCE)
    _wcam_json_text(json_${field} "${arg_${field}}")
  endforeach()

  if(WCAM_PLUGIN_OUTPUT_DIR)
    set(folder "${WCAM_PLUGIN_OUTPUT_DIR}")
  elseif(TARGET wcam_engine)
    set(folder "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/wcam/plugins/${WCAM_PLUGIN_ABI_MAJOR}")
  else()
    set(folder "${CMAKE_BINARY_DIR}/wcam-plugins")
  endif()
  file(GENERATE OUTPUT "${folder}/${arg_ID}.json" CONTENT
"{
  \"id\": ${json_ID},
  \"name\": ${json_NAME},
  \"version\": ${json_VERSION},
  \"vendor\": ${json_VENDOR},
  \"licence\": ${json_LICENCE},
  \"abi\": \"${WCAM_PLUGIN_ABI}\",
  \"library\": \"${arg_ID}.so\",
  \"kinds\": [${kinds}],
  \"components\": [
${components}
  ]
}
")

  add_library(${target} MODULE ${arg_SOURCES})
  target_link_libraries(${target} PRIVATE wcam::engine ${arg_LIBRARIES})
  if(TARGET wcam_options)
    target_link_libraries(${target} PRIVATE wcam_options)
  endif()
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_compile_definitions(${target} PRIVATE WCAM_PLUGIN_ID="${arg_ID}" WCAM_PLUGIN_VERSION="${arg_VERSION}")
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    target_compile_options(${target} PRIVATE -O2)
  endif()
  # Results must not depend on the processor.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  set_target_properties(${target} PROPERTIES
    PREFIX "" OUTPUT_NAME "${arg_ID}" SUFFIX ".so"
    LIBRARY_OUTPUT_DIRECTORY "$<1:${folder}>"
    CXX_VISIBILITY_PRESET hidden C_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)

  if(NOT DEFINED WCAM_PLUGIN_INSTALL_DIR)
    include(GNUInstallDirs)
    set(WCAM_PLUGIN_INSTALL_DIR "${CMAKE_INSTALL_LIBDIR}/wcam/plugins/${WCAM_PLUGIN_ABI_MAJOR}")
  endif()
  if(WCAM_PLUGIN_INSTALL_DIR)
    install(TARGETS ${target} LIBRARY DESTINATION "${WCAM_PLUGIN_INSTALL_DIR}" COMPONENT plugins)
    install(FILES "${folder}/${arg_ID}.json" DESTINATION "${WCAM_PLUGIN_INSTALL_DIR}" COMPONENT plugins)
  endif()
endfunction()
