# What `cmake --install` puts where: the command with its scripts, examples, manual page and completions (component
# `command`), and the library with headers and a CMake package (component `development`). All of it may be moved as one.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME command)

# The libraries of physics, and what they need.
set(physics contact rolling profiles wheelset wheel_contact cycles vehicle records spectra filters geometry_car track quality)
set(installed "")
set(todo ${physics})
while(todo)
  list(POP_FRONT todo name)
  if(NOT name IN_LIST installed)
    list(APPEND installed ${name})
    get_property(needs GLOBAL PROPERTY RAILBOOK_NEEDS_${name})
    list(APPEND todo ${needs})
  endif()
endwhile()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/railbook)
set(targets railbook_flags)
set_target_properties(railbook_flags PROPERTIES EXPORT_NAME flags)
foreach(name ${installed})
  set_target_properties(railbook_${name} PROPERTIES EXPORT_NAME ${name})
  list(APPEND targets railbook_${name})
  install(DIRECTORY lib/${name} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/railbook COMPONENT development
          FILES_MATCHING PATTERN *.hpp PATTERN detail EXCLUDE)
endforeach()
install(TARGETS ${targets} EXPORT railbook ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT command NAMELINK_COMPONENT development)
install(EXPORT railbook NAMESPACE railbook:: FILE railbook-targets.cmake DESTINATION ${package} COMPONENT development)
list(SORT installed)
configure_package_config_file(cmake/install/railbook-config.cmake.in ${PROJECT_BINARY_DIR}/railbook-config.cmake
                              INSTALL_DESTINATION ${package} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/railbook-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/railbook-config.cmake ${PROJECT_BINARY_DIR}/railbook-config-version.cmake
        DESTINATION ${package} COMPONENT development)

if(RAILBOOK_TOOLS)
  install(TARGETS railbook RUNTIME COMPONENT command)
  if(hdf5_FOUND)
    install(TARGETS railbook_container_reader RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/railbook COMPONENT command)
  endif()
endif()
install(DIRECTORY tools/ DESTINATION ${CMAKE_INSTALL_DATADIR}/railbook/tools FILES_MATCHING PATTERN *.gp
        PATTERN examples EXCLUDE)
install(FILES lib/plot/style.gp lib/plot/scene.gp DESTINATION ${CMAKE_INSTALL_DATADIR}/railbook/lib/plot)
install(FILES tools/quality/fra-49-cfr-213.csv DESTINATION ${CMAKE_INSTALL_DATADIR}/railbook/tools/quality)
install(DIRECTORY tools/verify/data DESTINATION ${CMAKE_INSTALL_DATADIR}/railbook/tools/verify)
install(DIRECTORY tools/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/railbook)

# Licences: ours, the notices of what is compiled into the programs, and the list of all of it.
configure_file(cmake/install/spdx.cmake.in ${PROJECT_BINARY_DIR}/spdx.cmake @ONLY)
install(SCRIPT cmake/install/source_date.cmake)
install(SCRIPT ${PROJECT_BINARY_DIR}/spdx.cmake)
install(FILES LICENSE SECURITY.md cmake/install/copyright ${PROJECT_BINARY_DIR}/railbook.spdx DESTINATION ${CMAKE_INSTALL_DOCDIR})

# The manual page and the completions are what the command says of itself (tools/CMakeLists.txt).
if(RAILBOOK_TOOLS AND NOT CMAKE_CROSSCOMPILING)
  set(pages ${PROJECT_BINARY_DIR}/pages)
  install(FILES ${pages}/railbook.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${pages}/railbook DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${pages}/_railbook DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
endif()

# `cpack` in the build folder makes a Debian package of all of it, the same bits for each who builds the same commit with the same
# compiler and libraries. Who publishes it gives an address: cpack -D CPACK_PACKAGE_CONTACT="Name <address>".
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME railbook)
string(REPLACE - ~ CPACK_PACKAGE_VERSION ${RAILBOOK_VERSION}) # to Debian 0.2.0-dev is later than 0.2.0, 0.2.0~dev earlier
set(CPACK_PACKAGE_CONTACT "The railbook maintainers")
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/install/source_date.cmake)
set(CPACK_POST_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/install/repack.cmake)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, cmake, libeigen3-dev, libgsl-dev, libfftw3-dev, libfmt-dev, zlib1g-dev")
# With the module of Python there are two packages: railbook, and python3-railbook for the interpreter that it was built with.
if(RAILBOOK_PYTHON)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
  set(CPACK_COMPONENT_COMMAND_GROUP railbook)
  set(CPACK_COMPONENT_DEVELOPMENT_GROUP railbook)
  set(CPACK_COMPONENT_PYTHON_GROUP python)
  set(CPACK_DEBIAN_RAILBOOK_PACKAGE_NAME railbook)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-railbook)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "")
endif()
include(CPack)
