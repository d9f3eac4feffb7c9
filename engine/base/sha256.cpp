// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/sha256.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"

#include <openssl/evp.h>

#include <bit>

namespace wcam {

struct Sha256::Impl {
  EVP_MD_CTX* context = EVP_MD_CTX_new();

  Impl() {
    WCAM_ASSERT(context != nullptr && EVP_DigestInit_ex(context, EVP_sha256(), nullptr) == 1);
  }

  ~Impl() { EVP_MD_CTX_free(context); }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
};

Sha256::Sha256() : impl_(std::make_unique<Impl>()) {}

Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

Sha256& Sha256::bytes(const void* data, std::size_t size) {
  WCAM_ASSERT(EVP_DigestUpdate(impl_->context, data, size) == 1);
  return *this;
}

Sha256& Sha256::text(std::string_view text) {
  integer(static_cast<std::int64_t>(text.size()));
  return bytes(text.data(), text.size());
}

Sha256& Sha256::number(double number) {
  // -0 and 0 are the same parameter.
  return integer(std::bit_cast<std::int64_t>(number == 0.0 ? 0.0 : number));
}

Sha256& Sha256::integer(std::int64_t number) {
  static_assert(std::endian::native == std::endian::little);
  return bytes(&number, sizeof number);
}

std::string Sha256::hex() {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  WCAM_ASSERT(EVP_DigestFinal_ex(impl_->context, digest, &size) == 1 && size == 32);
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < size; ++i) {
    text += kDigits[digest[i] >> 4];
    text += kDigits[digest[i] & 15];
  }
  return text;
}

std::string sha256Hex(std::string_view data) {
  return Sha256().bytes(data.data(), data.size()).hex();
}

std::string sha256OfFile(const std::filesystem::path& file) {
  return sha256Hex(readFile(file));
}

}  // namespace wcam
