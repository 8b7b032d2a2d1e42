# geodesic_proto_library(<target> [MESSAGES_ONLY] [ROOT <dir>] <proto>...)
#
# Makes a static library of the messages and gRPC stubs generated from protos
# that lie below ROOT, their import root (default: the current source
# directory). MESSAGES_ONLY leaves the stubs out.
function(geodesic_proto_library target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "MESSAGES_ONLY" "ROOT" "")
  if(NOT arg_ROOT)
    set(arg_ROOT ${CMAKE_CURRENT_SOURCE_DIR})
  endif()
  set(out ${CMAKE_CURRENT_BINARY_DIR})
  set(endings .pb.cc .pb.h)
  set(stubs)
  if(NOT arg_MESSAGES_ONLY)
    list(APPEND endings .grpc.pb.cc .grpc.pb.h)
    set(stubs --grpc_out=${out}
        --plugin=protoc-gen-grpc=$<TARGET_FILE:gRPC::grpc_cpp_plugin>)
  endif()
  set(sources)
  foreach(proto IN LISTS arg_UNPARSED_ARGUMENTS)
    string(REGEX REPLACE "\\.proto$" "" stem ${proto})
    list(TRANSFORM endings PREPEND ${out}/${stem} OUTPUT_VARIABLE generated)
    add_custom_command(
      OUTPUT ${generated}
      COMMAND protobuf::protoc
        -I ${arg_ROOT} --cpp_out=${out} ${stubs} ${arg_ROOT}/${proto}
      DEPENDS ${arg_ROOT}/${proto}
      VERBATIM)
    list(APPEND sources ${generated})
    # These share names; the stubs are compiled together, so that they read
    # gRPC's headers once.
    set_source_files_properties(${out}/${stem}.pb.cc
      PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endforeach()
  add_library(${target} STATIC ${sources})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
  target_include_directories(${target} SYSTEM PUBLIC
    $<BUILD_INTERFACE:${out}>)
  target_link_libraries(${target} PUBLIC protobuf::libprotobuf)
  if(NOT arg_MESSAGES_ONLY)
    target_link_libraries(${target} PUBLIC gRPC::grpc++)
  endif()
endfunction()
