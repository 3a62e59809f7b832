// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <preview/reference_file.h>
#include <renderer/fixtures.h>

namespace preview {
namespace {

namespace fs = std::filesystem;

class ReferenceFile : public testing::Test {
protected:
    std::string make(const std::string &name) const {
        const fs::path path = fs::path(m_folder.file(name)).lexically_normal();
        fs::create_directories(path.parent_path());
        std::ofstream(path) << "x";
        return path.string();
    }

    std::string find() const {
        return findReference(m_folder.file("scenes/homework/cbox/cbox_ems.xml"));
    }

    nori::test::TemporaryFolder m_folder;
};

TEST_F(ReferenceFile, IsNotAnEarlierRenderBesideTheScene) {
    make("scenes/homework/cbox/cbox_ems.exr");
    make("scenes/homework/cbox/cbox_ems_64.exr");
    make("references/homework/cbox/cbox_mis.exr");
    EXPECT_EQ(find(), "");
}

TEST_F(ReferenceFile, IsFoundInEveryPlaceNearestFirst) {
    for (const char *name :
         {"references/cbox_ems_a.exr", "references/cbox_ems.exr",
          "references/homework/cbox/cbox_ems_a.exr", "references/scenes/homework/cbox/cbox_ems.exr",
          "scenes/references/homework/cbox/cbox_ems_ref.exr",
          "scenes/homework/cbox/references/cbox_ems.exr", "scenes/homework/cbox/cbox_ems_ref.exr",
          "scenes/homework/cbox/cbox_ems_reference.exr"})
        EXPECT_EQ(find(), make(name));
}

TEST_F(ReferenceFile, IsFoundFromARelativePath) {
    const std::string reference = make("scenes/references/cbox_ems.exr");
    const fs::path before = fs::current_path();
    fs::current_path(fs::path(reference).parent_path());
    const std::string found = findReference("../homework/cbox/cbox_ems.xml");
    fs::current_path(before);
    EXPECT_EQ(fs::weakly_canonical(found), fs::weakly_canonical(reference));
}

TEST_F(ReferenceFile, IsKnownForTheProjectsOwnScenes) {
    EXPECT_EQ(findReference(NORI_SOURCE_DIR "/scenes/assignment-2/table/table_ems.xml"),
              NORI_SOURCE_DIR "/references/assignment-2/table/table_ems_a.exr");
}

} // namespace
} // namespace preview
