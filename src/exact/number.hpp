// Exact arithmetic on doubles: every double is an integer times a power of two, and so is every sum, difference and
// product of them. A number is a sign, an exponent and up to `Capacity` 32-bit limbs; nothing is ever rounded. When a
// result would need more limbs the number says so (`overflowed`), and stays so in all that is made from it.
//
// There is no allocation: the limbs are in place, and only those in use are copied.
#pragma once

#include <bit>
#include <cstdint>

namespace surefoot::internal {

template <int Capacity>
class ExactNumber {
public:
    constexpr ExactNumber() noexcept {}

    /// Requires: `value` is finite.
    explicit ExactNumber(double value) noexcept {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        const auto biased = static_cast<int>((bits >> 52) & 0x7ff);
        std::uint64_t mantissa = bits & 0x000fffffffffffffULL;
        if (biased != 0) mantissa |= 0x0010000000000000ULL;
        if (mantissa == 0) return;
        sign_ = (bits >> 63) != 0 ? -1 : 1;
        // value = mantissa * 2^power; split the power into whole limbs and a shift.
        const int power = (biased == 0 ? 1 : biased) - 1075;
        exponent_ = floor_to_limbs(power);
        const int shift = power - 32 * exponent_;
        const std::uint64_t low = mantissa << shift;
        limbs_[0] = static_cast<std::uint32_t>(low);
        limbs_[1] = static_cast<std::uint32_t>(low >> 32);
        limbs_[2] = shift == 0 ? 0 : static_cast<std::uint32_t>(mantissa >> (64 - shift));
        size_ = 3;
        trim();
    }

    ExactNumber(const ExactNumber& other) noexcept { assign(other); }
    ExactNumber& operator=(const ExactNumber& other) noexcept {
        if (this != &other) assign(other);
        return *this;
    }

    /// -1, 0 or 1. Means nothing when `overflowed()`.
    [[nodiscard]] int sign() const noexcept { return sign_; }
    [[nodiscard]] bool overflowed() const noexcept { return overflowed_; }

    friend ExactNumber operator-(const ExactNumber& a) noexcept {
        ExactNumber result = a;
        result.sign_ = -a.sign_;
        return result;
    }

    friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) noexcept { return sum(a, b, b.sign_); }
    friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) noexcept { return sum(a, b, -b.sign_); }

    friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) noexcept {
        ExactNumber result;
        result.overflowed_ = a.overflowed_ || b.overflowed_;
        if (a.sign_ == 0 || b.sign_ == 0) return result;
        if (a.size_ + b.size_ > Capacity) {
            result.overflowed_ = true;
            return result;
        }
        result.sign_ = a.sign_ * b.sign_;
        result.exponent_ = a.exponent_ + b.exponent_;
        result.size_ = a.size_ + b.size_;
        for (int i = 0; i < result.size_; ++i) result.limbs_[i] = 0;
        for (int i = 0; i < a.size_; ++i) {
            std::uint64_t carry = 0;
            for (int j = 0; j < b.size_; ++j) {
                carry += static_cast<std::uint64_t>(a.limbs_[i]) * b.limbs_[j] + result.limbs_[i + j];
                result.limbs_[i + j] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
            result.limbs_[i + b.size_] = static_cast<std::uint32_t>(carry);
        }
        result.trim();
        return result;
    }

    /// a / b to about 15 digits, of any size. Requires: b is not zero.
    friend double ratio(const ExactNumber& a, const ExactNumber& b) noexcept {
        double value = a.leading() / b.leading();
        int power = a.top() - b.top();
        for (; power > 0 && value > -1e290 && value < 1e290 && value != 0; --power) value *= 0x1p32;
        for (; power < 0 && value != 0; ++power) value *= 0x1p-32;
        return value;
    }

    /// The number over 2^(32 * top()): at least 2^-32 and less than 1 in size, to 15 digits.
    [[nodiscard]] double leading() const noexcept {
        double value = 0;
        const int lowest = size_ > 3 ? size_ - 3 : 0;
        for (int i = lowest; i < size_; ++i) value = (value + limbs_[i]) * 0x1p-32;
        return sign_ < 0 ? -value : value;
    }
    [[nodiscard]] int top() const noexcept { return exponent_ + size_; }

    /// Times 2^(32 * limbs).
    [[nodiscard]] ExactNumber shifted(int limbs) const noexcept {
        ExactNumber result = *this;
        if (sign_ != 0) result.exponent_ += limbs;
        return result;
    }

    /// The same number without what lies below its highest `limbs` limbs.
    [[nodiscard]] ExactNumber truncated(int limbs) const noexcept {
        ExactNumber result = *this;
        if (size_ <= limbs) return result;
        const int dropped = size_ - limbs;
        for (int i = 0; i < limbs; ++i) result.limbs_[i] = limbs_[i + dropped];
        result.size_ = limbs;
        result.exponent_ += dropped;
        result.trim();
        return result;
    }

private:
    static constexpr int floor_to_limbs(int power) noexcept { return power >= 0 ? power / 32 : -((31 - power) / 32); }

    void assign(const ExactNumber& other) noexcept {
        sign_ = other.sign_;
        overflowed_ = other.overflowed_;
        size_ = other.size_;
        exponent_ = other.exponent_;
        for (int i = 0; i < size_; ++i) limbs_[i] = other.limbs_[i];
    }

    // No zero limbs at either end: sizes stay small and zero has one form.
    void trim() noexcept {
        while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
        int zeros = 0;
        while (zeros < size_ && limbs_[zeros] == 0) ++zeros;
        if (zeros > 0) {
            for (int i = zeros; i < size_; ++i) limbs_[i - zeros] = limbs_[i];
            size_ -= zeros;
            exponent_ += zeros;
        }
        if (size_ == 0) sign_ = exponent_ = 0;
    }

    // The limb that counts 2^(32 * place).
    [[nodiscard]] std::uint32_t limb_at(int place) const noexcept {
        const int i = place - exponent_;
        return i >= 0 && i < size_ ? limbs_[i] : 0;
    }

    static ExactNumber sum(const ExactNumber& a, const ExactNumber& b, int b_sign) noexcept {
        if (b_sign == 0) {
            ExactNumber result = a;
            result.overflowed_ = a.overflowed_ || b.overflowed_;
            return result;
        }
        if (a.sign_ == 0) {
            ExactNumber result = b;
            result.sign_ = b_sign;
            result.overflowed_ = a.overflowed_ || b.overflowed_;
            return result;
        }
        ExactNumber result;
        result.overflowed_ = a.overflowed_ || b.overflowed_;
        const int bottom = a.exponent_ < b.exponent_ ? a.exponent_ : b.exponent_;
        const int a_top = a.exponent_ + a.size_;
        const int b_top = b.exponent_ + b.size_;
        const int top = (a_top < b_top ? b_top : a_top) + 1;
        if (top - bottom > Capacity) {
            result.overflowed_ = true;
            return result;
        }
        result.exponent_ = bottom;
        result.size_ = top - bottom;
        if (a.sign_ == b_sign) {
            result.sign_ = b_sign;
            std::uint64_t carry = 0;
            for (int place = bottom; place < top; ++place) {
                carry += static_cast<std::uint64_t>(a.limb_at(place)) + b.limb_at(place);
                result.limbs_[place - bottom] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
        } else {
            // The larger magnitude minus the smaller, with the larger one's sign.
            const bool a_is_larger = compare_magnitudes(a, b) >= 0;
            const ExactNumber& big = a_is_larger ? a : b;
            const ExactNumber& small = a_is_larger ? b : a;
            result.sign_ = a_is_larger ? a.sign_ : b_sign;
            std::int64_t borrow = 0;
            for (int place = bottom; place < top; ++place) {
                std::int64_t digit = static_cast<std::int64_t>(big.limb_at(place)) - small.limb_at(place) - borrow;
                borrow = digit < 0 ? 1 : 0;
                if (digit < 0) digit += 4294967296LL;
                result.limbs_[place - bottom] = static_cast<std::uint32_t>(digit);
            }
        }
        result.trim();
        return result;
    }

    static int compare_magnitudes(const ExactNumber& a, const ExactNumber& b) noexcept {
        const int a_top = a.exponent_ + a.size_;
        const int b_top = b.exponent_ + b.size_;
        if (a_top != b_top) return a_top < b_top ? -1 : 1;
        const int bottom = a.exponent_ < b.exponent_ ? a.exponent_ : b.exponent_;
        for (int place = a_top - 1; place >= bottom; --place) {
            const std::uint32_t a_limb = a.limb_at(place);
            const std::uint32_t b_limb = b.limb_at(place);
            if (a_limb != b_limb) return a_limb < b_limb ? -1 : 1;
        }
        return 0;
    }

    int sign_ = 0;
    int size_ = 0;
    int exponent_ = 0;  // the lowest limb counts 2^(32 * exponent_)
    bool overflowed_ = false;
    std::uint32_t limbs_[Capacity];
};

/// -1, 0 or 1 for a < b, a == b, a > b.
template <int Capacity>
int compare(const ExactNumber<Capacity>& a, const ExactNumber<Capacity>& b) noexcept {
    return (a - b).sign();
}

}  // namespace surefoot::internal
