// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/sha256.hpp"

#include "wcam/base/file_io.hpp"

#include "error_matchers.hpp"
#include "test_folder.hpp"

namespace wcam {
namespace {

// FIPS 180-4, examples of NIST.
TEST(Sha256, KnownDigests) {
  EXPECT_EQ(sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256Hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256Hex(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, PiecesGiveTheSame) {
  Sha256 hash;
  hash.bytes("a", 1).bytes("", 0).bytes("bc", 2);
  EXPECT_EQ(hash.hex(), sha256Hex("abc"));
}

TEST(Sha256, TypedFeedsDoNotRunTogether) {
  EXPECT_NE(Sha256().text("ab").text("c").hex(), Sha256().text("a").text("bc").hex());
  EXPECT_NE(Sha256().number(1.0).hex(), Sha256().integer(1).hex());
  EXPECT_EQ(Sha256().number(-0.0).hex(), Sha256().number(0.0).hex());
}

TEST(Sha256, OfAFile) {
  const testing::TestFolder folder;
  writeFileAtomically(folder / "a", std::string("a\0b", 3));
  EXPECT_EQ(sha256OfFile(folder / "a"), sha256Hex(std::string("a\0b", 3)));
  EXPECT_THAT(testing::errorOf(ErrorCode::InputNotFound, [&] { (void)sha256OfFile(folder / "b"); }),
              ::testing::HasSubstr(pathText(folder / "b")));
}

}  // namespace
}  // namespace wcam
