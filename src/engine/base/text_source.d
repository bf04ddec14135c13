engine/base/text_source.o: engine/base/text_source.cpp \
 engine/base/text_source.hpp engine/base/error.hpp
engine/base/text_source.hpp:
engine/base/error.hpp:
