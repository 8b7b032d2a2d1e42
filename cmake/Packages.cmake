# The Debian packages that `cpack -G DEB` makes; scripts/package does it all.
#
# package          components      holds
# geodesic-server  server          geodesicd, its unit, settings and man page
# geodesic-client  command         geodesic, man pages, completions
# libgeodesic-dev  core, client    headers, static libraries, what finds them
# python3-geodesic python          the Python package

# As Debian's tools have it.
if(DEFINED ENV{DEBEMAIL})
  set(CPACK_PACKAGE_CONTACT "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
  set(CPACK_PACKAGE_CONTACT "geodesic maintainers <maintainers@geodesic.invalid>")
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME geodesic)
# Each package has a summary of its own, the first line of its description.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
  WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL server command core client python)
set(CPACK_COMPONENT_CORE_GROUP dev)
set(CPACK_COMPONENT_CLIENT_GROUP dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SOURCE geodesic)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(scripts ${PROJECT_SOURCE_DIR}/deploy/debian)
set(about "This is a service and a library for geodesic distances: how far it is from
one place of a triangle mesh to another along the surface, and which way. They
are exact up to rounding.")

set(CPACK_DEBIAN_SERVER_PACKAGE_NAME geodesic-server)
set(CPACK_DEBIAN_SERVER_PACKAGE_SECTION science)
set(CPACK_DEBIAN_SERVER_PACKAGE_DEPENDS "adduser, init-system-helpers (>= 1.54~)")
set(CPACK_DEBIAN_SERVER_PACKAGE_SUGGESTS geodesic-client)
set(CPACK_DEBIAN_SERVER_PACKAGE_CONTROL_EXTRA
  ${scripts}/server/postinst ${scripts}/server/prerm ${scripts}/server/postrm
  ${scripts}/server/conffiles)
set(CPACK_DEBIAN_SERVER_DESCRIPTION "server for exact geodesic distances on triangle meshes
${about}

geodesicd keeps meshes in memory and on disk and answers over gRPC.")

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME geodesic-client)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION science)
# Without a server elsewhere, the command starts geodesicd.
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS geodesic-server)
set(CPACK_DEBIAN_COMMAND_DESCRIPTION "command line for exact geodesic distances on triangle meshes
${about}

geodesic asks a server and writes tables, meshes and pictures.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libgeodesic-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "libabsl-dev, libopenmesh-dev, libsuitesparse-dev, zlib1g-dev, libpugixml-dev")
# For the component client.
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS
  "libgrpc++-dev, libprotobuf-dev, libssl-dev, protobuf-compiler, protobuf-compiler-grpc")
set(CPACK_DEBIAN_DEV_DESCRIPTION "libraries for exact geodesic distances on triangle meshes
${about}

Headers and static libraries: one that computes, one that asks a server; with
files for CMake and pkg-config.")

math(EXPR next_python "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-geodesic)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "python3 (>= 3.${Python3_VERSION_MINOR}~), python3 (<< 3.${next_python}), python3-numpy")
# What geodesic.connect needs.
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-grpcio, python3-protobuf")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS
  "python3-matplotlib, python3-scipy, python3-tqdm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  ${scripts}/python/postinst ${scripts}/python/prerm)
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "exact geodesic distances on triangle meshes, for Python
${about}

The package geodesic computes in the process, or asks a server.")

# What Debian wants in /usr/share/doc/PACKAGE.
execute_process(COMMAND date --rfc-email OUTPUT_VARIABLE date
  OUTPUT_STRIP_TRAILING_WHITESPACE)
configure_file(${scripts}/changelog.in changelog.Debian @ONLY)
configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog COPYONLY)
foreach(log IN ITEMS changelog changelog.Debian)
  execute_process(COMMAND ${GZIP_PROGRAM} -9nkf ${PROJECT_BINARY_DIR}/${log}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
function(install_documents component package)
  install(FILES ${PROJECT_SOURCE_DIR}/deploy/debian/copyright
                ${PROJECT_BINARY_DIR}/changelog.gz
                ${PROJECT_BINARY_DIR}/changelog.Debian.gz
    DESTINATION share/doc/${package} COMPONENT ${component})
endfunction()
install_documents(server geodesic-server)
install_documents(command geodesic-client)
install_documents(core libgeodesic-dev)
install_documents(python python3-geodesic)

include(CPack)
