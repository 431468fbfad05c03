package dev.eventchain.endtoend;

import dev.eventchain.diagnostics.Sha256;
import java.io.IOException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * The distribution's zip, unpacked into a read-only folder on a minimal machine: the {@code PATH}
 * leads to a Java without compiler, Python and basic system tools.
 */
final class Installation {

  private static final Path TARGET = Program.ROOT.resolve("bundles/front/distribution/target");
  private static final List<String> SYSTEM =
      List.of(
          "bash",
          "env",
          "readlink",
          "dirname",
          "sed",
          "grep",
          "mkdir",
          "mktemp",
          "mv",
          "touch",
          "rm");
  private static final Set<PosixFilePermission> WRITE =
      PosixFilePermissions.fromString("-w--w--w-");

  private final Path folder;
  private final Path home;

  /** Unpacks the zip into a folder. */
  Installation(Path folder) throws IOException {
    this.folder = folder;
    Path program = Files.createDirectory(folder.resolve("a program"));
    try (FileSystem zip =
        FileSystems.newFileSystem(zip(), Map.of("enablePosixFileAttributes", true))) {
      try (Stream<Path> entries = Files.walk(zip.getPath("/"))) {
        for (Path entry : entries.skip(1).toList()) {
          unpack(entry, program.resolve(entry.toString().substring(1)));
        }
      }
    }
    try (Stream<Path> roots = Files.list(program)) {
      home = roots.findFirst().orElseThrow();
    }
    withoutWriting(home);
    Path commands = Files.createDirectory(folder.resolve("commands"));
    for (String name : SYSTEM) {
      Files.createSymbolicLink(commands.resolve(name), onPath(name));
    }
    script(commands.resolve("java"), "exec '" + realJava() + "' \"$@\"");
  }

  /** Returns the archive that the build packed. */
  static Path zip() throws IOException {
    try (Stream<Path> files = Files.list(TARGET)) {
      return files.filter(file -> file.toString().endsWith(".zip")).findFirst().orElseThrow();
    }
  }

  Path home() {
    return home;
  }

  /** Returns the only folder on the {@code PATH}. */
  Path commands() {
    return folder.resolve("commands");
  }

  /** Returns the folder of the program's cache. */
  Path cache() throws IOException {
    return Files.createDirectories(folder.resolve("cache"));
  }

  private static void unpack(Path entry, Path target) throws IOException {
    if (Files.isDirectory(entry)) {
      Files.createDirectories(target);
    } else {
      Files.createDirectories(target.getParent());
      Files.copy(entry, target);
      Files.setLastModifiedTime(target, Files.getLastModifiedTime(entry));
      Files.setPosixFilePermissions(target, Files.getPosixFilePermissions(entry));
    }
  }

  private static void withoutWriting(Path home) throws IOException {
    try (Stream<Path> files = Files.walk(home)) {
      for (Path file : files.toList()) {
        Set<PosixFilePermission> some = EnumSet.copyOf(Files.getPosixFilePermissions(file));
        some.removeAll(WRITE);
        Files.setPosixFilePermissions(file, some);
      }
    }
  }

  /** Makes the folder writable, since JUnit can remove only writable ones. */
  void mayBeRemoved() throws IOException {
    try (Stream<Path> files = Files.walk(home)) {
      for (Path file : files.filter(Files::isDirectory).toList()) {
        Set<PosixFilePermission> all = EnumSet.copyOf(Files.getPosixFilePermissions(file));
        all.add(PosixFilePermission.OWNER_WRITE);
        Files.setPosixFilePermissions(file, all);
      }
    }
  }

  /** Returns all files of the installation with their contents. */
  SortedMap<String, String> content() throws IOException {
    SortedMap<String, String> content = new TreeMap<>();
    try (Stream<Path> files = Files.walk(home)) {
      for (Path file : files.toList()) {
        Sha256 digest = new Sha256();
        if (Files.isRegularFile(file)) {
          digest.add(Files.readAllBytes(file));
        }
        content.put(home.relativize(file).toString(), digest.abbreviated());
      }
    }
    return content;
  }

  /** Starts {@code bin/eventchain}, or a program before it, and waits for its end. */
  Program.Ended run(List<String> before, Map<String, String> settings, Object... arguments)
      throws IOException {
    List<String> command = new ArrayList<>(before);
    command.add(home.resolve("bin/eventchain").toString());
    Stream.of(arguments).map(Object::toString).forEach(command::add);
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().clear();
    builder.environment().put("PATH", commands().toString());
    builder.environment().put("XDG_CACHE_HOME", cache().toString());
    builder.environment().putAll(settings);
    Path out = Files.createTempFile(folder, "run", ".out");
    Path err = Files.createTempFile(folder, "run", ".err");
    Process process =
        builder.redirectOutput(out.toFile()).redirectError(err.toFile()).start().onExit().join();
    return new Program.Ended(process.exitValue(), Files.readString(out), Files.readString(err));
  }

  /** Returns a program of this machine. */
  static Path onPath(String name) {
    return Stream.of(System.getenv("PATH").split(":", -1))
        .map(entry -> Path.of(entry, name))
        .filter(Files::isExecutable)
        .findFirst()
        .orElseThrow(() -> new IllegalStateException("there is no " + name));
  }

  static String realJava() {
    return Path.of(System.getProperty("java.home"), "bin", "java").toString();
  }

  /** Writes a script for {@code sh}. */
  static void script(Path file, String body) throws IOException {
    Files.writeString(file, "#!" + onPath("sh") + "\n" + body + "\n");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
  }
}
