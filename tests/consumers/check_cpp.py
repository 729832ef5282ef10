"""Installs the C++ libraries, moves them elsewhere, and uses them from a project outside this repository.

    EVENLIFT_BUILD=build/native EVENLIFT_PROGRAM=build/bin/evenlift python3 tests/consumers/check_cpp.py

It checks that find_package() and pkg-config find them, and require nothing (but pugixml, for drawings);
that a wrong version is refused; that the project's results equal the program's; and that each public header compiles
alone.
"""

import concurrent.futures
import os
import shutil
import sys

from installed import build, compiler, expect, installed_into, library_folder, main, program, root, run, samples, version

# Needed only by the build. CMake treats them as missing, and the project must still configure.
not_needed = ["Eigen3", "nlohmann_json", "CLI11", "Catch2", "rapidcheck", "Boost", "benchmark", "SDL2", "Python3"]
bears = "20\n20\n20\n20\n"
drawing = "2 shapes. 6 robots carry 16.7 kg each (100 kg in all).\n".replace(" kg", "\u00a0kg")


def configure(prefix, source, folder, *options, status=0):
    cxx, flags = compiler()
    return run(
        "cmake", "-S", source, "-B", folder, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_COMPILER={cxx}",
        f"-DCMAKE_CXX_FLAGS={' '.join(flags)}", *options, expect=status,
    )  # fmt: skip


def check_cmake(prefix, source, folder):
    without = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in not_needed]
    without_drawings = folder / "without-drawings"
    configure(prefix, source, without_drawings, *without, "-DCMAKE_DISABLE_FIND_PACKAGE_pugixml=ON", "-DWITH_DRAWINGS=OFF")
    run("cmake", "--build", without_drawings)
    built = folder / "built"
    configure(prefix, source, built, *without)
    run("cmake", "--build", built)
    expect((built / "version.txt").read_text().strip() == version(), "the package and the program have different versions")
    check_programs(without_drawings, samples[:3])
    check_programs(built, samples)
    expect(run(built / "drawing") == drawing, f"the drawing's placement is another: {run(built / 'drawing')}")
    # For drawings without pugixml, it says so and stops.
    if "find_package(pugixml" in next(prefix.glob("**/evenlift-config.cmake")).read_text():
        configure(prefix, source, folder / "no-pugixml", "-DCMAKE_DISABLE_FIND_PACKAGE_pugixml=ON", status=1)


def check_programs(place, polygons):
    expect(run(place / "bears") == bears, f"robots bear {run(place / 'bears')}")
    for sample in polygons:
        expect(
            run(place / "results", sample) == run(program, "place", sample, "--json"),
            f"{sample.name}: the library's JSON is not the program's",
        )


def check_wrong_version(prefix, source, folder):
    """A later version is refused when requested, and so is an incompatible one."""
    major, minor, _ = version().split(".")
    for wanted in (f"{int(major) + 1}.0", f"{major}.{int(minor) + 1}", f"{int(major) - 1}.9"):
        asking = folder / f"asks-for-{wanted}"
        shutil.copytree(source, asking)
        text = (asking / "CMakeLists.txt").read_text()
        (asking / "CMakeLists.txt").write_text(text.replace("find_package(evenlift 2.0", f"find_package(evenlift {wanted}"))
        configure(prefix, asking, asking / "build", status=1)


def pkg_config(prefix, *arguments):
    found = run("pkg-config", *arguments, PKG_CONFIG_PATH=str(library_folder(prefix) / "pkgconfig"))
    return found.split()


def check_pkg_config(prefix, source, folder):
    cxx, flags = compiler()
    folder.mkdir()
    for name, package in (("bears", "evenlift"), ("results", "evenlift"), ("drawing", "evenlift-import")):
        use = pkg_config(prefix, "--cflags", "--libs", package)
        run(cxx, "-std=c++20", *flags, source / f"{name}.cpp", "-o", folder / name, *use)
        expect(pkg_config(prefix, "--modversion", package) == [version()], f"{package}.pc has another version")
    check_programs(folder, samples[:3])
    expect(run(folder / "drawing") == drawing, "the drawing's placement is another with pkg-config")
    needed = " ".join(pkg_config(prefix, "--print-requires", "--print-requires-private", "evenlift"))
    expect(not needed, f"evenlift.pc asks for {needed}")


def check_headers(prefix):
    """Each public header by itself, twice, without warnings, and only with the flags from pkg-config."""
    cxx, _ = compiler()
    folder = prefix / "include"
    headers = sorted(path.relative_to(folder) for path in folder.glob("evenlift/**/*.h"))
    sources = sorted(path.relative_to(root / "core/include") for path in (root / "core/include").glob("evenlift/**/*.h"))
    expect(set(headers) >= set(sources), f"not installed: {set(sources) - set(headers)}")
    flags = pkg_config(prefix, "--cflags", "evenlift")

    options = ["-std=c++20", "-Wall", "-Wextra", "-Werror", *flags]

    def compiles(header):
        text = folder.parent / f"{'-'.join(header.parts)}.cpp"
        text.write_text(f"#include <{header}>\n#include <{header}>\n")
        run(cxx, *options, "-fsyntax-only", text)

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
        list(threads.map(compiles, headers))
    return len(headers)


def check_inclusion(source, folder):
    """As a part of another project it needs neither the program's nor the tests' libraries. Compiling it would take
    minutes and is left out."""
    shutil.copytree(source, folder)
    (folder / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.24)\nproject(other LANGUAGES CXX)\n"
        f'add_subdirectory("{root}" evenlift)\nadd_executable(bears bears.cpp)\n'
        "target_link_libraries(bears PRIVATE evenlift::core)\n"
    )
    without = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in not_needed if name not in ("Eigen3", "nlohmann_json")]
    configure(folder, folder, folder / "build", "-DEVENLIFT_DOWNLOADS=OFF", *without)
    expect(not (folder / "build/bin").exists(), "it builds a program of ours")


def check(folder):
    prefix = installed_into(folder)
    source = folder / "consumer"
    shutil.copytree(root / "tests/consumers/cpp", source)
    check_cmake(prefix, source, folder / "cmake")
    check_wrong_version(prefix, source, folder)
    check_pkg_config(prefix, source, folder / "pkg-config")
    check_inclusion(source, folder / "included")
    headers = check_headers(prefix)
    expect(str(build) not in "".join(path.read_text() for path in prefix.glob("**/*.cmake")), "the package knows its build folder")
    return f"{len(samples)} samples, {headers} headers"


sys.exit(main(check))
