cpp11.o: cpp11.cpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/declarations.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/R.hpp \
 /usr/share/R/include/Rinternals.h /usr/share/R/include/R_ext/Arith.h \
 /usr/share/R/include/R_ext/libextern.h \
 /usr/share/R/include/R_ext/Boolean.h \
 /usr/share/R/include/R_ext/Complex.h /usr/share/R/include/R_ext/Error.h \
 /usr/share/R/include/R_ext/Memory.h /usr/share/R/include/R_ext/Utils.h \
 /usr/share/R/include/R_ext/Print.h /usr/share/R/include/R_ext/Rdynload.h \
 /usr/share/R/include/Rconfig.h \
 /usr/lib/R/site-library/cpp11/include/cpp11/altrep.hpp \
 /usr/share/R/include/Rversion.h \
 /usr/lib/R/site-library/cpp11/include/cpp11/as.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/protect.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/attribute_proxy.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/data_frame.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/list.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/named_arg.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/sexp.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/r_string.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/r_vector.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/doubles.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/environment.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/external_pointer.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/r_bool.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/function.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/integers.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/list_of.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/logicals.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/matrix.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/raws.hpp \
 /usr/lib/R/site-library/cpp11/include/cpp11/strings.hpp \
 /usr/share/R/include/R_ext/Visibility.h
/usr/lib/R/site-library/cpp11/include/cpp11/declarations.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/R.hpp:
/usr/share/R/include/Rinternals.h:
/usr/share/R/include/R_ext/Arith.h:
/usr/share/R/include/R_ext/libextern.h:
/usr/share/R/include/R_ext/Boolean.h:
/usr/share/R/include/R_ext/Complex.h:
/usr/share/R/include/R_ext/Error.h:
/usr/share/R/include/R_ext/Memory.h:
/usr/share/R/include/R_ext/Utils.h:
/usr/share/R/include/R_ext/Print.h:
/usr/share/R/include/R_ext/Rdynload.h:
/usr/share/R/include/Rconfig.h:
/usr/lib/R/site-library/cpp11/include/cpp11/altrep.hpp:
/usr/share/R/include/Rversion.h:
/usr/lib/R/site-library/cpp11/include/cpp11/as.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/protect.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/attribute_proxy.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/data_frame.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/list.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/named_arg.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/sexp.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/r_string.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/r_vector.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/doubles.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/environment.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/external_pointer.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/r_bool.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/function.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/integers.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/list_of.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/logicals.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/matrix.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/raws.hpp:
/usr/lib/R/site-library/cpp11/include/cpp11/strings.hpp:
/usr/share/R/include/R_ext/Visibility.h:
