"""Names that a component may import from modules: an allow list, so names added by new versions are not allowed.

All of them are deterministic functions, classes and constants: no modules, files, clocks, random numbers, addresses, or
access to attributes by computed names. Taken from the documentation of Python 3.10 to 3.14 and NumPy 2; a name that a
version lacks is allowed, but missing.
"""

from __future__ import annotations

ALLOWED_NAMES = {
    module: frozenset(names.split())
    for module, names in {
        "__future__": "absolute_import annotations division print_function",
        "abc": "ABC abstractmethod",
        "array": "ArrayType array typecodes",
        "bisect": "bisect bisect_left bisect_right insort insort_left insort_right",
        "cmath": """
            acos acosh asin asinh atan atanh cos cosh e exp inf infj isclose isfinite isinf isnan log log10 nan nanj
            phase pi polar rect sin sinh sqrt tan tanh tau
        """,
        "collections": "ChainMap Counter OrderedDict UserDict UserList UserString defaultdict deque namedtuple",
        "collections.abc": """
            AsyncGenerator AsyncIterable AsyncIterator Awaitable Buffer ByteString Callable Collection Container
            Coroutine Generator Hashable ItemsView Iterable Iterator KeysView Mapping MappingView MutableMapping
            MutableSequence MutableSet Reversible Sequence Set Sized ValuesView
        """,
        "copy": "Error copy deepcopy",
        "dataclasses": """
            FrozenInstanceError InitVar KW_ONLY MISSING asdict astuple dataclass field fields is_dataclass replace
        """,
        "decimal": """
            Clamped Context ConversionSyntax Decimal DecimalException DecimalTuple DivisionByZero DivisionImpossible
            DivisionUndefined FloatOperation Inexact InvalidContext InvalidOperation MAX_EMAX MAX_PREC MIN_EMIN
            MIN_ETINY Overflow ROUND_05UP ROUND_CEILING ROUND_DOWN ROUND_FLOOR ROUND_HALF_DOWN ROUND_HALF_EVEN
            ROUND_HALF_UP ROUND_UP Rounded Subnormal Underflow getcontext localcontext
        """,
        "enum": """
            CONFORM CONTINUOUS EJECT Enum Flag FlagBoundary IntEnum IntFlag KEEP NAMED_FLAGS STRICT StrEnum UNIQUE
            auto member nonmember unique verify
        """,
        "fractions": "Fraction",
        "functools": "cache cached_property cmp_to_key lru_cache partial partialmethod reduce total_ordering",
        "heapq": "heapify heappop heappush heappushpop heapreplace merge nlargest nsmallest",
        "itertools": """
            accumulate batched chain combinations combinations_with_replacement compress count cycle dropwhile
            filterfalse groupby islice pairwise permutations product repeat starmap takewhile tee zip_longest
        """,
        "math": """
            acos acosh asin asinh atan atan2 atanh cbrt ceil comb copysign cos cosh degrees dist e erf erfc exp exp2
            expm1 fabs factorial floor fma fmod frexp fsum gamma gcd hypot inf isclose isfinite isinf isnan isqrt lcm
            ldexp lgamma log log10 log1p log2 modf nan nextafter perm pi pow prod radians remainder sin sinh sqrt
            sumprod tan tanh tau trunc ulp
        """,
        "numbers": "Complex Integral Number Rational Real",
        "numpy": """
            False_ True_ abs absolute acos acosh add all allclose amax amin angle any append apply_along_axis
            apply_over_axes arange arccos arccosh arcsin arcsinh arctan arctan2 arctanh argmax argmin argpartition
            argsort argwhere around array array2string array_equal array_equiv array_repr array_split array_str
            asanyarray asarray asarray_chkfinite ascontiguousarray asfortranarray asin asinh asmatrix astype atan
            atan2 atanh atleast_1d atleast_2d atleast_3d average bartlett base_repr binary_repr bincount bitwise_and
            bitwise_count bitwise_invert bitwise_left_shift bitwise_not bitwise_or bitwise_right_shift bitwise_xor
            blackman block bmat bool bool_ broadcast broadcast_arrays broadcast_shapes broadcast_to byte bytes_ c_
            can_cast cbrt cdouble ceil character choose clip clongdouble column_stack common_type complex128
            complex256 complex64 complexfloating compress concat concatenate conj conjugate convolve copy copysign
            copyto corrcoef correlate cos cosh count_nonzero cov cross csingle cumprod cumsum cumulative_prod
            cumulative_sum deg2rad degrees delete diag diag_indices diag_indices_from diagflat diagonal diff digitize
            divide divmod dot double dsplit dstack dtype e ediff1d einsum einsum_path empty empty_like equal errstate
            euler_gamma exp exp2 expand_dims expm1 extract eye fabs fill_diagonal finfo fix flatiter flatnonzero
            flexible flip fliplr flipud float128 float16 float32 float64 float_power floating floor floor_divide fmax
            fmin fmod format_float_positional format_float_scientific frexp frombuffer fromfunction fromiter
            frompyfunc fromstring full full_like gcd generic geomspace gradient greater greater_equal half hamming
            hanning heaviside histogram histogram2d histogram_bin_edges histogramdd hsplit hstack hypot i0 identity
            iinfo imag in1d index_exp indices inexact inf inner insert int16 int32 int64 int8 int_ intc integer
            interp intersect1d intp invert isclose iscomplex iscomplexobj isdtype isfinite isfortran isin isinf isnan
            isnat isneginf isposinf isreal isrealobj isscalar issubdtype iterable ix_ kaiser kron lcm ldexp
            left_shift less less_equal lexsort linspace little_endian log log10 log1p log2 logaddexp logaddexp2
            logical_and logical_not logical_or logical_xor logspace long longdouble longlong mask_indices matmul
            matrix matrix_transpose matvec max maximum mean median meshgrid mgrid min min_scalar_type minimum
            mintypecode mod modf moveaxis multiply nan nan_to_num nanargmax nanargmin nancumprod nancumsum nanmax
            nanmean nanmedian nanmin nanpercentile nanprod nanquantile nanstd nansum nanvar ndarray ndenumerate ndim
            ndindex nditer negative newaxis nextafter nonzero not_equal number object_ ogrid ones ones_like outer
            packbits pad partition percentile permute_dims pi piecewise place poly poly1d polyadd polyder polydiv
            polyfit polyint polymul polysub polyval positive pow power printoptions prod promote_types ptp put
            put_along_axis putmask quantile r_ rad2deg radians ravel ravel_multi_index real real_if_close reciprocal
            remainder repeat require reshape resize result_type right_shift rint roll rollaxis roots rot90 round
            row_stack s_ searchsorted select setdiff1d setxor1d shape short sign signbit signedinteger sin sinc
            single sinh size sort sort_complex spacing split sqrt square squeeze stack std str_ subtract sum swapaxes
            take take_along_axis tan tanh tensordot tile timedelta64 trace transpose trapezoid trapz tri tril
            tril_indices tril_indices_from trim_zeros triu triu_indices triu_indices_from true_divide trunc typename
            ubyte ufunc uint uint16 uint32 uint64 uint8 uintc uintp ulong ulonglong union1d unique unique_all
            unique_counts unique_inverse unique_values unpackbits unravel_index unsignedinteger unstack unwrap ushort
            vander var vdot vecdot vecmat vectorize void vsplit vstack where zeros zeros_like
        """,
        "numpy.fft": """
            fft fft2 fftfreq fftn fftshift hfft ifft ifft2 ifftn ifftshift ihfft irfft irfft2 irfftn rfft rfft2
            rfftfreq rfftn
        """,
        "numpy.lib": "",
        "numpy.lib.stride_tricks": "sliding_window_view",
        "numpy.linalg": """
            LinAlgError cholesky cond cross det diagonal eig eigh eigvals eigvalsh inv lstsq matmul matrix_norm
            matrix_power matrix_rank matrix_transpose multi_dot norm outer pinv qr slogdet solve svd svdvals
            tensordot tensorinv tensorsolve trace vecdot vector_norm
        """,
        "numpy.polynomial": "Chebyshev Hermite HermiteE Laguerre Legendre Polynomial",
        "numpy.polynomial.polynomial": """
            Polynomial polyadd polyder polydiv polyfit polyfromroots polyint polymul polymulx polypow polyroots
            polysub polyval polyval2d polyvander
        """,
        "numpy.typing": "ArrayLike DTypeLike NDArray",
        "operator": """
            abs add and_ concat contains countOf delitem eq floordiv ge getitem gt iadd iand iconcat ifloordiv
            ilshift imatmul imod imul index indexOf inv invert ior ipow irshift is_ is_not isub itemgetter itruediv
            ixor le length_hint lshift lt matmul mod mul ne neg not_ or_ pos pow rshift setitem sub truediv truth xor
        """,
        "statistics": """
            StatisticsError correlation covariance fmean geometric_mean harmonic_mean kde linear_regression mean
            median median_grouped median_high median_low mode multimode pstdev pvariance quantiles stdev variance
        """,
        "string": """
            Template ascii_letters ascii_lowercase ascii_uppercase capwords digits hexdigits octdigits printable
            punctuation whitespace
        """,
        "struct": "Struct calcsize error iter_unpack pack pack_into unpack unpack_from",
        "typing": """
            AbstractSet Annotated Any AnyStr AsyncContextManager AsyncGenerator AsyncIterable AsyncIterator Awaitable
            ByteString Callable ChainMap ClassVar Collection Concatenate Container ContextManager Coroutine Counter
            DefaultDict Deque Dict Final FrozenSet Generator Generic Hashable ItemsView Iterable Iterator KeysView
            List Literal LiteralString Mapping MappingView MutableMapping MutableSequence MutableSet NamedTuple Never
            NewType NoDefault NoReturn NotRequired Optional OrderedDict ParamSpec ParamSpecArgs ParamSpecKwargs
            Protocol ReadOnly Required Reversible Self Sequence Set Sized SupportsAbs SupportsBytes SupportsComplex
            SupportsFloat SupportsIndex SupportsInt SupportsRound TYPE_CHECKING Text Tuple Type TypeAlias TypeGuard
            TypeIs TypeVar TypeVarTuple TypedDict Union Unpack ValuesView assert_never assert_type cast final
            overload override runtime_checkable
        """,
    }.items()
}

# Forbidden names of libraries with the reason for the user.
RANDOM_NAMES = frozenset({"random", "kde_random", "NormalDist"})
FILE_NAMES = frozenset(
    {"DataSource", "ctypeslib", "fromfile", "fromregex", "genfromtxt", "load", "loadtxt", "memmap", "save", "savetxt"}
    | {"savez", "savez_compressed"}
)
CLOCK_NAMES = frozenset({"datetime64", "busday_count", "busday_offset", "busdaycalendar", "is_busday"})


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


# Attributes of frames, code, generators, classes and arrays that lead out of the component or to memory addresses.
REACHING_ATTRIBUTES = _words("""
    ag_await ag_code ag_frame ag_running ag_suspended cr_await cr_code cr_frame cr_origin cr_running cr_suspended
    gi_code gi_frame gi_running gi_suspended gi_yieldfrom f_back f_builtins f_code f_generator f_globals f_lasti
    f_lineno f_locals f_trace tb_frame tb_lasti tb_lineno tb_next co_code co_consts co_filename co_freevars co_names
    co_varnames cell_contents buffer_info ctypes dump dumps fromfile mro tofile
""")
# Special methods that a class may define: operators and collections, not copying, pickling or attribute lookup.
_OPERATIONS = _words("add and divmod floordiv lshift matmul mod mul or pow rshift sub truediv xor")
_OTHERS = _words("""
    abs bool call ceil complex contains copy deepcopy delitem enter eq exit float floor format ge getitem gt hash index
    init init_subclass int invert iter le len length_hint lt missing ne neg new next pos post_init repr reversed round
    setitem str trunc
""")
SPECIAL_METHODS = frozenset(
    {f"__{prefix}{name}__" for name in _OPERATIONS for prefix in ("", "r", "i")} | {f"__{name}__" for name in _OTHERS}
)
