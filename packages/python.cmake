# The component `python`: the package, and what tells pip and importlib.metadata of it.
find_package(Python REQUIRED COMPONENTS Interpreter)  # the one that the module is built for
set(OVERBEND_PYTHON_DIR "" CACHE STRING "Folder of Python packages below the prefix; empty: where Python looks there")
set(METADATA ${CMAKE_CURRENT_BINARY_DIR}/METADATA)
set(INSTALLER ${CMAKE_CURRENT_BINARY_DIR}/INSTALLER)
add_custom_command(
  OUTPUT ${METADATA}
  COMMAND ${OVERBEND_PYTHON} ${CMAKE_CURRENT_SOURCE_DIR}/python_metadata.py > ${METADATA}
  DEPENDS python_metadata.py ${PROJECT_SOURCE_DIR}/CMakeLists.txt ${PROJECT_SOURCE_DIR}/README.md
  VERBATIM)
file(CONFIGURE OUTPUT ${INSTALLER} CONTENT "cmake\n")
add_custom_target(overbend_python_installed ALL DEPENDS ${METADATA} ${COPYRIGHT})
add_dependencies(overbend_python_installed overbend_python_package)
add_dependencies(overbend_installed overbend_python_installed)

# The prefix is known when it is installed, not before.
install(CODE "set(python_dir \"${OVERBEND_PYTHON_DIR}\")
if(NOT python_dir)
  execute_process(COMMAND \"${OVERBEND_PYTHON}\" \"${CMAKE_CURRENT_SOURCE_DIR}/python_folder.py\" \"\${CMAKE_INSTALL_PREFIX}\"
                  OUTPUT_VARIABLE python_dir OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
endif()" COMPONENT python)
install(TARGETS overbend_python LIBRARY DESTINATION "\${python_dir}/overbend" COMPONENT python)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/python/overbend DESTINATION "\${python_dir}" COMPONENT python
        FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/src/overbend/dynamics/machines/overbend_controller.h
        DESTINATION "\${python_dir}/overbend/include" COMPONENT python)
install(FILES ${METADATA} ${INSTALLER} DESTINATION "\${python_dir}/overbend-${PROJECT_VERSION}.dist-info"
        COMPONENT python)
install(FILES ${COPYRIGHT} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-overbend COMPONENT python)
