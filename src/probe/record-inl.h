// SPDX-License-Identifier: MIT
// Records in lanes: one record per lane, as 32-bit words, from which fields become floats and which
// fields are put together to.
#if defined(GAUNT_PROBE_RECORD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GAUNT_PROBE_RECORD_INL_H_
#undef GAUNT_PROBE_RECORD_INL_H_
#else
#define GAUNT_PROBE_RECORD_INL_H_
#endif

#include "probe/format.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gaunt::probe::HWY_NAMESPACE {

using namespace gaunt::HWY_NAMESPACE;  // NOLINT(build/namespaces)

// Times which tiny floats are what they stand for.
inline constexpr double kPerTiny = 0x1p112;

// Lanes that also know words, which are vectors of floats of whose bits they are made.
struct RecordLanes : Lanes {
  using U = hn::RebindToUnsigned<LaneTag>;
  using I = hn::RebindToSigned<LaneTag>;

  static GAUNT_LANES hn::Vec<U> Bits(V v) { return hn::BitCast(U(), v); }
  template <class Integers>
  static GAUNT_LANES V Word(Integers bits) {
    return hn::BitCast(LaneTag(), bits);
  }

  // The integer of some bits of a word, without a sign and in two's complement.
  template <int kShift, int kWidth>
  GAUNT_LANES V Unsigned(V word) const {
    auto bits = Bits(word);
    if constexpr (kShift != 0) bits = hn::ShiftRight<kShift>(bits);
    if constexpr (kShift + kWidth < 32) bits = hn::And(bits, hn::Set(U(), (1u << kWidth) - 1));
    return hn::ConvertTo(LaneTag(), hn::BitCast(I(), bits));
  }
  template <int kShift, int kWidth>
  GAUNT_LANES V Signed(V word) const {
    auto bits = hn::BitCast(I(), word);
    if constexpr (kShift + kWidth < 32) bits = hn::ShiftLeft<32 - kShift - kWidth>(bits);
    return hn::ConvertTo(LaneTag(), hn::ShiftRight<32 - kWidth>(bits));
  }
  // Times 2^24, a byte in two's complement: it need not be shifted down.
  template <int kShift>
  GAUNT_LANES V SignedByte(V word) const {
    auto bits = Bits(word);
    if constexpr (kShift != 24) bits = hn::ShiftLeft<24 - kShift>(bits);
    if constexpr (kShift != 0) bits = hn::And(bits, hn::Set(U(), 0xFF000000u));
    return hn::ConvertTo(LaneTag(), hn::BitCast(I(), bits));
  }
  // The topmost bit of each byte the other way round.
  GAUNT_LANES V FlipSigns(V word) const {
    return Word(hn::Xor(Bits(word), hn::Set(U(), 0x80808080u)));
  }
  // A half float, and a small one without a sign: their bits as those of a float, which is then too
  // small by kPerTiny. Exact for the smallest, too.
  template <int kShift>
  GAUNT_LANES V TinyHalf(V word) const {
    auto bits = hn::BitCast(I(), word);
    if constexpr (kShift == 0) bits = hn::ShiftLeft<16>(bits);
    const auto mask = hn::Set(I(), static_cast<int32_t>(0x8FFFE000u));
    return Word(hn::And(hn::ShiftRight<3>(bits), mask));
  }
  template <int kShift, int kMantissa>
  GAUNT_LANES V TinyFloat(V word) const {
    auto bits = Bits(word);
    if constexpr (kShift != 0) bits = hn::ShiftRight<kShift>(bits);
    bits = hn::And(bits, hn::Set(U(), (1u << (5 + kMantissa)) - 1));
    return Word(hn::ShiftLeft<23 - kMantissa>(bits));
  }
  // 2^(e - bias) of an exponent in the topmost bits, made as the bits of a float.
  template <int kShift, int kBias>
  GAUNT_LANES V Power(V word) const {
    const auto exponent = hn::Add(hn::ShiftRight<kShift>(Bits(word)), hn::Set(U(), 127u - kBias));
    return Word(hn::ShiftLeft<23>(exponent));
  }

  // 2^floor(log2(v)) of a normal v > 0, and e of 2^(e - bias).
  GAUNT_LANES V PowerOfTwo(V v) const { return Word(hn::And(Bits(v), hn::Set(U(), 0x7F800000u))); }
  template <int kBias>
  GAUNT_LANES V Exponent(V power) const {
    return Word(hn::Sub(hn::ShiftRight<23>(Bits(power)), hn::Set(U(), 127u - kBias)));
  }
  // The bits of an integer of less than 2^22, of which a field keeps the lowest.
  template <int kWidth>
  GAUNT_LANES V Integer(V v) const {
    const auto bits = Bits(Word(hn::ConvertTo(I(), v)));
    return Word(hn::And(bits, hn::Set(U(), (1u << kWidth) - 1)));
  }
  // The bits of a float of exponents of 5 bits, of v in 0 .. the largest, rounded to nearest even.
  template <int kMantissa>
  GAUNT_LANES V SmallFloatBits(V v) const {
    constexpr int kDropped = 23 - kMantissa;
    const auto bits = Bits(v);
    const auto odd = hn::And(hn::ShiftRight<kDropped>(bits), hn::Set(U(), 1u));
    const auto rounded = hn::Add(hn::Add(bits, hn::Set(U(), (1u << (kDropped - 1)) - 1)), odd);
    const auto normal = hn::ShiftRight<kDropped>(hn::Sub(rounded, hn::Set(U(), 112u << 23)));
    // Below 2^-14 the last place is always the same, and that of the sum with this number.
    const V base = (*this)(kMantissa == 10 ? 0x1p-1 : kMantissa == 6 ? 0x1p3 : 0x1p4);
    const auto small = hn::Sub(Bits(Add(v, base)), Bits(base));
    return IfThenElse(Lt(v, (*this)(0x1p-14)), Word(small), Word(normal));
  }
  GAUNT_LANES V HalfBits(V v) const {
    const auto sign = hn::And(hn::ShiftRight<16>(Bits(v)), hn::Set(U(), 0x8000u));
    return Word(hn::Or(Bits(SmallFloatBits<10>(Abs(v))), sign));
  }

  // Adds to a field of a word, as far as it goes. It is in two's complement if `least` is negative.
  GAUNT_LANES V AddToField(V word, int shift, int width, int32_t least, int32_t most,
                           int32_t step) const {
    const uint32_t mask = width == 32 ? ~0u : (1u << width) - 1;
    const auto high = hn::ShiftLeftSame(Bits(word), 32 - shift - width);
    const auto number = least < 0 ? hn::ShiftRightSame(hn::BitCast(I(), high), 32 - width)
                                  : hn::BitCast(I(), hn::ShiftRightSame(high, 32 - width));
    const auto sum = hn::Add(number, hn::Set(I(), step));
    const auto limited = hn::Min(hn::Max(sum, hn::Set(I(), least)), hn::Set(I(), most));
    const auto bits = hn::And(hn::BitCast(U(), limited), hn::Set(U(), mask));
    const auto others = hn::And(Bits(word), hn::Set(U(), ~(mask << shift)));
    return Word(hn::Or(others, hn::ShiftLeftSame(bits, shift)));
  }

  template <int kShift>
  GAUNT_LANES V Left(V word) const {
    return Word(hn::ShiftLeft<kShift>(Bits(word)));
  }
  GAUNT_LANES V Or(V a, V b) const { return Word(hn::Or(Bits(a), Bits(b))); }
};

// Where the words of a record begin, in bytes, as they are loaded: 16 bytes at a time and nothing
// beyond the record, so that the last may overlap those before.
template <size_t kBytes>
struct LoadedWords {
  static_assert(kBytes == 4 || kBytes >= 8, "");
  static constexpr int kCount = kBytes == 4 ? 1 : static_cast<int>((kBytes + 15) / 16 * 4);
  static constexpr size_t Offset(int word) {
    const size_t begin = static_cast<size_t>(word / 4) * 16, place = static_cast<size_t>(word % 4);
    if (kBytes == 4) return 0;
    if (kBytes < 16) return (place < 2 ? 0 : kBytes - 8) + place % 2 * 4;
    return (begin + 16 <= kBytes ? begin : kBytes - 16) + place * 4;
  }
};
// The same, one word after the other, as they are put together.
template <size_t kBytes>
struct DenseWords {
  static constexpr int kCount = static_cast<int>((kBytes + 3) / 4);
  static constexpr size_t Offset(int word) { return static_cast<size_t>(word) * 4; }
};

// The word that has a field, which begins `shift` bits from its lowest.
template <class Words, int kBit, int kWidth>
struct Field {
  static constexpr int Find() {
    for (int word = 0; word < Words::kCount; ++word) {
      const int begin = static_cast<int>(8 * Words::Offset(word));
      if (begin <= kBit && kBit + kWidth <= begin + 32) return word;
    }
    return -1;
  }
  static constexpr int kWord = Find();
  static_assert(kWord >= 0, "a field has to lie in a word");
  static constexpr int kShift = kBit - static_cast<int>(8 * Words::Offset(kWord));
};

// Records of a group of lanes, read field by field.
template <class Words, class Planes>
struct RecordIn {
  Planes words;

  template <int kBit, int kWidth, class K>
  GAUNT_LANES auto Unsigned(const K& k) const {
    using F = Field<Words, kBit, kWidth>;
    return k.template Unsigned<F::kShift, kWidth>(words(F::kWord));
  }
  template <int kBit, int kWidth, class K>
  GAUNT_LANES auto Signed(const K& k) const {
    using F = Field<Words, kBit, kWidth>;
    return k.template Signed<F::kShift, kWidth>(words(F::kWord));
  }
  // Times 2^24, a byte with a sign, and one without a sign less 128.
  template <int kBit, class K>
  GAUNT_LANES auto SignedByte(const K& k) const {
    using F = Field<Words, kBit, 8>;
    return k.template SignedByte<F::kShift>(words(F::kWord));
  }
  template <int kBit, class K>
  GAUNT_LANES auto ByteLess128(const K& k) const {
    using F = Field<Words, kBit, 8>;
    return k.template SignedByte<F::kShift>(k.FlipSigns(words(F::kWord)));
  }
  template <int kBit, class K>
  GAUNT_LANES auto TinyHalf(const K& k) const {
    using F = Field<Words, kBit, 16>;
    static_assert(F::kShift == 0 || F::kShift == 16, "");
    return k.template TinyHalf<F::kShift>(words(F::kWord));
  }
  template <int kBit, class K>
  GAUNT_LANES auto Float(const K&) const {
    return words(Field<Words, kBit, 32>::kWord);
  }
  template <int kBit, int kMantissa, class K>
  GAUNT_LANES auto TinyFloat(const K& k) const {
    using F = Field<Words, kBit, 5 + kMantissa>;
    return k.template TinyFloat<F::kShift, kMantissa>(words(F::kWord));
  }
  template <int kBit, int kBias, class K>
  GAUNT_LANES auto Power(const K& k) const {
    using F = Field<Words, kBit, 5>;
    static_assert(F::kShift == 27, "");
    return k.template Power<F::kShift, kBias>(words(F::kWord));
  }
};

// Records of a group of lanes, put together field by field; the rest is 0.
template <size_t kBytes, class K>
class RecordOut {
 public:
  using Words = DenseWords<kBytes>;

  explicit GAUNT_LANES RecordOut(const K& k) : k_(k) {
    for (int word = 0; word < Words::kCount; ++word) words_(static_cast<size_t>(word), k(0.0));
  }
  template <int kBit, int kWidth>
  GAUNT_LANES void Put(typename K::V bits) {
    using F = Field<Words, kBit, kWidth>;
    const auto shifted = k_.template Left<F::kShift>(bits);
    words_(F::kWord, k_.Or(words_(F::kWord), shifted));
  }
  template <class In>
  GAUNT_LANES void Load(const In& in) {
    for (size_t word = 0; word < Words::kCount; ++word) words_(word, in(word));
  }
  template <class Out>
  GAUNT_LANES void Write(const Out& out) const {
    for (size_t word = 0; word < Words::kCount; ++word) out(word, words_(word));
  }
  GAUNT_LANES auto Word(size_t word) const { return words_(word); }
  GAUNT_LANES void SetWord(size_t word, typename K::V bits) { words_(word, bits); }
  GAUNT_LANES auto Read() const {
    const auto planes = words_.Planes();
    return RecordIn<Words, decltype(planes)>{planes};
  }

 private:
  K k_;
  typename K::template Slots<Words::kCount> words_;
};

}  // namespace gaunt::probe::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GAUNT_PROBE_RECORD_INL_H_
