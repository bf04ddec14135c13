engine/elements/bending.o: engine/elements/bending.cpp \
 engine/elements/bending.hpp engine/elements/kind.hpp \
 engine/elements/../base/block_sink.hpp \
 engine/elements/../base/fields.hpp engine/elements/../base/geometry.hpp \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/Core \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/DisableStupidWarnings.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/Macros.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/MKL_support.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/Constants.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/Meta.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/ForwardDeclarations.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/StaticAssert.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/XprHelper.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/Memory.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/NumTraits.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/MathFunctions.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/GenericPacketMath.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/MathFunctionsImpl.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/Default/ConjHelper.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/SSE/PacketMath.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/SSE/MathFunctions.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/SSE/Complex.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/SSE/TypeCasting.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/CUDA/Half.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/CUDA/PacketMathHalf.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/CUDA/TypeCasting.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/Default/Settings.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/TernaryFunctors.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/BinaryFunctors.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/UnaryFunctors.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/NullaryFunctors.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/StlFunctors.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/AssignmentFunctors.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/CUDA/Complex.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/IO.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/DenseCoeffsBase.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/DenseBase.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/BlockMethods.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/MatrixBase.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/CommonCwiseUnaryOps.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/CommonCwiseBinaryOps.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/MatrixCwiseUnaryOps.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/MatrixCwiseBinaryOps.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/EigenBase.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Product.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CoreEvaluators.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/AssignEvaluator.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Assign.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/ArrayBase.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/ArrayCwiseUnaryOps.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/ArrayCwiseBinaryOps.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/BlasUtil.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/DenseStorage.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/NestByValue.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/ReturnByValue.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/NoAlias.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/PlainObjectBase.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Matrix.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Array.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CwiseTernaryOp.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CwiseBinaryOp.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CwiseUnaryOp.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CwiseNullaryOp.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CwiseUnaryView.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/SelfCwiseBinaryOp.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Dot.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/StableNorm.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Stride.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/MapBase.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Map.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Ref.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Block.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/VectorBlock.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Transpose.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/DiagonalMatrix.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Diagonal.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/DiagonalProduct.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Redux.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Visitor.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Fuzzy.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Swap.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CommaInitializer.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/GeneralProduct.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Solve.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Inverse.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/SolverBase.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/PermutationMatrix.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Transpositions.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/TriangularMatrix.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/SelfAdjointView.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/GeneralBlockPanelKernel.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/Parallelizer.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/ProductEvaluators.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/GeneralMatrixVector.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/GeneralMatrixMatrix.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/SolveTriangular.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/GeneralMatrixMatrixTriangular.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/SelfadjointMatrixVector.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/SelfadjointMatrixMatrix.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/SelfadjointProduct.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/SelfadjointRank2Update.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/TriangularMatrixVector.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/TriangularMatrixMatrix.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/TriangularSolverMatrix.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/TriangularSolverVector.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/BandMatrix.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CoreIterators.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/ConditionEstimator.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/BooleanRedux.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Select.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/VectorwiseOp.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Random.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Replicate.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Reverse.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/ArrayWrapper.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/GlobalFunctions.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/ReenableStupidWarnings.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/Geometry \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/Core \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/SVD \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/QR \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/Cholesky \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/Jacobi \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Jacobi/Jacobi.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Cholesky/LLT.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Cholesky/LDLT.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/Householder \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Householder/Householder.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Householder/HouseholderSequence.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Householder/BlockHouseholder.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/QR/HouseholderQR.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/QR/FullPivHouseholderQR.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/QR/ColPivHouseholderQR.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/QR/CompleteOrthogonalDecomposition.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/misc/RealSvd2x2.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/SVD/UpperBidiagonalization.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/SVD/SVDBase.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/SVD/JacobiSVD.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/SVD/BDCSVD.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/LU \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/misc/Kernel.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/misc/Image.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/LU/FullPivLU.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/LU/PartialPivLU.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/LU/Determinant.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/LU/InverseImpl.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/LU/arch/Inverse_SSE.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/OrthoMethods.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/EulerAngles.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Homogeneous.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/RotationBase.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Rotation2D.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Quaternion.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/AngleAxis.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Transform.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Translation.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Scaling.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Hyperplane.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/ParametrizedLine.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/AlignedBox.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Umeyama.h \
 /usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/arch/Geometry_SSE.h \
 engine/elements/../base/ground.hpp engine/elements/../base/immersion.hpp \
 engine/elements/../base/water.hpp engine/elements/../base/waves.hpp
engine/elements/bending.hpp:
engine/elements/kind.hpp:
engine/elements/../base/block_sink.hpp:
engine/elements/../base/fields.hpp:
engine/elements/../base/geometry.hpp:
/usr/lib/R/site-library/RcppEigen/include/Eigen/Core:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/DisableStupidWarnings.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/Macros.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/MKL_support.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/Constants.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/Meta.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/ForwardDeclarations.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/StaticAssert.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/XprHelper.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/Memory.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/NumTraits.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/MathFunctions.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/GenericPacketMath.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/MathFunctionsImpl.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/Default/ConjHelper.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/SSE/PacketMath.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/SSE/MathFunctions.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/SSE/Complex.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/SSE/TypeCasting.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/CUDA/Half.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/CUDA/PacketMathHalf.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/CUDA/TypeCasting.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/Default/Settings.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/TernaryFunctors.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/BinaryFunctors.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/UnaryFunctors.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/NullaryFunctors.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/StlFunctors.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/functors/AssignmentFunctors.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/arch/CUDA/Complex.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/IO.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/DenseCoeffsBase.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/DenseBase.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/BlockMethods.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/MatrixBase.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/CommonCwiseUnaryOps.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/CommonCwiseBinaryOps.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/MatrixCwiseUnaryOps.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/MatrixCwiseBinaryOps.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/EigenBase.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Product.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CoreEvaluators.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/AssignEvaluator.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Assign.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/ArrayBase.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/ArrayCwiseUnaryOps.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/../plugins/ArrayCwiseBinaryOps.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/BlasUtil.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/DenseStorage.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/NestByValue.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/ReturnByValue.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/NoAlias.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/PlainObjectBase.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Matrix.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Array.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CwiseTernaryOp.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CwiseBinaryOp.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CwiseUnaryOp.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CwiseNullaryOp.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CwiseUnaryView.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/SelfCwiseBinaryOp.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Dot.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/StableNorm.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Stride.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/MapBase.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Map.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Ref.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Block.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/VectorBlock.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Transpose.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/DiagonalMatrix.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Diagonal.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/DiagonalProduct.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Redux.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Visitor.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Fuzzy.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Swap.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CommaInitializer.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/GeneralProduct.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Solve.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Inverse.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/SolverBase.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/PermutationMatrix.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Transpositions.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/TriangularMatrix.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/SelfAdjointView.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/GeneralBlockPanelKernel.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/Parallelizer.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/ProductEvaluators.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/GeneralMatrixVector.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/GeneralMatrixMatrix.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/SolveTriangular.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/GeneralMatrixMatrixTriangular.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/SelfadjointMatrixVector.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/SelfadjointMatrixMatrix.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/SelfadjointProduct.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/SelfadjointRank2Update.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/TriangularMatrixVector.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/TriangularMatrixMatrix.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/TriangularSolverMatrix.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/products/TriangularSolverVector.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/BandMatrix.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/CoreIterators.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/ConditionEstimator.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/BooleanRedux.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Select.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/VectorwiseOp.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Random.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Replicate.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/Reverse.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/ArrayWrapper.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/GlobalFunctions.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Core/util/ReenableStupidWarnings.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/Geometry:
/usr/lib/R/site-library/RcppEigen/include/Eigen/Core:
/usr/lib/R/site-library/RcppEigen/include/Eigen/SVD:
/usr/lib/R/site-library/RcppEigen/include/Eigen/QR:
/usr/lib/R/site-library/RcppEigen/include/Eigen/Cholesky:
/usr/lib/R/site-library/RcppEigen/include/Eigen/Jacobi:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Jacobi/Jacobi.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Cholesky/LLT.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Cholesky/LDLT.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/Householder:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Householder/Householder.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Householder/HouseholderSequence.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Householder/BlockHouseholder.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/QR/HouseholderQR.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/QR/FullPivHouseholderQR.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/QR/ColPivHouseholderQR.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/QR/CompleteOrthogonalDecomposition.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/misc/RealSvd2x2.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/SVD/UpperBidiagonalization.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/SVD/SVDBase.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/SVD/JacobiSVD.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/SVD/BDCSVD.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/LU:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/misc/Kernel.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/misc/Image.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/LU/FullPivLU.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/LU/PartialPivLU.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/LU/Determinant.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/LU/InverseImpl.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/LU/arch/Inverse_SSE.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/OrthoMethods.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/EulerAngles.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Homogeneous.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/RotationBase.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Rotation2D.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Quaternion.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/AngleAxis.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Transform.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Translation.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Scaling.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Hyperplane.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/ParametrizedLine.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/AlignedBox.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/Umeyama.h:
/usr/lib/R/site-library/RcppEigen/include/Eigen/src/Geometry/arch/Geometry_SSE.h:
engine/elements/../base/ground.hpp:
engine/elements/../base/immersion.hpp:
engine/elements/../base/water.hpp:
engine/elements/../base/waves.hpp:
