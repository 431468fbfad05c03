package dev.eventchain.sandbox;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * The bubblewrap command (bwrap(1)). It gives a process the system's libraries, its readable paths
 * and its work folder. There is no /proc, no /sys, no /tmp, and only the work folder is writable.
 */
final class Bubblewrap {

  private static final List<String> LIBRARIES =
      List.of("/usr", "/lib", "/lib64", "/lib32", "/bin", "/nix/store", "/etc/ld.so.cache");
  private static final List<String> DEVICES =
      List.of("/dev/null", "/dev/urandom", "/dev/random", "/dev/zero");

  private Bubblewrap() {}

  /**
   * Returns the command line up to the program, without the separator.
   *
   * @param network true for the network of this machine, false for no network
   */
  static List<String> command(Collection<Path> readable, Path workFolder, boolean network) {
    List<String> line = new ArrayList<>(List.of("bwrap", "--unshare-all", "--die-with-parent"));
    line.addAll(network ? List.of("--share-net") : List.of());
    line.addAll(List.of("--new-session", "--cap-drop", "ALL"));
    for (String library : LIBRARIES) {
      show(line, Path.of(library));
    }
    for (String device : DEVICES) {
      line.addAll(List.of("--dev-bind", device, device));
    }
    // Outer folders first: later mounts cover earlier ones.
    TreeSet<Path> ordered =
        new TreeSet<>(
            Comparator.comparingInt(Path::getNameCount).thenComparing(Comparator.naturalOrder()));
    ordered.addAll(readable);
    ordered.add(workFolder);
    Set<Path> shown = new HashSet<>();
    LIBRARIES.forEach(library -> shown.add(Path.of(library)));
    for (Path path : ordered) {
      boolean isWork = path.equals(workFolder);
      Path around = nearest(path, shown);
      if (isWork || around == null || around.equals(workFolder)) {
        line.addAll(List.of(isWork ? "--bind" : "--ro-bind-try", path.toString(), path.toString()));
        shown.add(path);
      }
    }
    line.addAll(List.of("--remount-ro", "/", "--chdir", workFolder.toString()));
    return line;
  }

  private static Path nearest(Path path, Set<Path> shown) {
    Path around = path;
    while (around != null && !shown.contains(around)) {
      around = around.getParent();
    }
    return around;
  }

  private static void show(List<String> line, Path path) {
    try {
      if (Files.isSymbolicLink(path)) {
        String target = Files.readSymbolicLink(path).toString();
        line.addAll(List.of("--symlink", target, path.toString()));
      } else if (Files.exists(path)) {
        line.addAll(List.of("--ro-bind", path.toString(), path.toString()));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
