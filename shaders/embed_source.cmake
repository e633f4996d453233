# cmake -D GLSLANG=... -D FOLDER=... -D SOURCE=... -D OUTPUT=... -D DEFINE=... -P: writes a shader with all that it includes as one C++ string.
execute_process(COMMAND ${GLSLANG} -E -S comp ${DEFINE} -I${FOLDER} ${SOURCE} OUTPUT_VARIABLE text RESULT_VARIABLE status)
if(NOT status EQUAL 0)
	message(FATAL_ERROR "${SOURCE}: ${text}")
endif()
# Without paths of the machine it was built on, and without what comments leave.
string(REGEX REPLACE "#line[^\n]*\n" "" text "${text}")
string(REGEX REPLACE "\n[ \t\n]*\n" "\n" text "${text}")
file(WRITE ${OUTPUT} "R\"glsl(${text})glsl\"\n")
