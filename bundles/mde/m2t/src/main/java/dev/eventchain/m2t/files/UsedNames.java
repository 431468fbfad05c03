package dev.eventchain.m2t.files;

import dev.eventchain.output.ProtectedAreas;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;

/** Names of a run's files and of their folders, which other files cannot have. */
final class UsedNames {

  private final Set<String> files;
  private final Set<String> folders = new HashSet<>();

  /**
   * Names that no file may have, because their file for lost areas would collide with another file.
   */
  private final Set<String> losers = new HashSet<>();

  /**
   * Starts without folders.
   *
   * @param files the names of the files that are written, which change later
   */
  UsedNames(Set<String> files) {
    this.files = files;
  }

  /** Adds what follows from the name of a new file. */
  void add(String path) {
    if (path.endsWith(ProtectedAreas.LOST)) {
      losers.add(path.substring(0, path.length() - ProtectedAreas.LOST.length()));
    }
    for (int slash = path.lastIndexOf('/'); slash >= 0; slash = path.lastIndexOf('/', slash - 1)) {
      if (!folders.add(path.substring(0, slash))) {
        break;
      }
    }
  }

  /** Returns why a new file cannot have a name; empty if it can. */
  Optional<String> collisionOf(String path) {
    String problem = "";
    if (folders.contains(path)) {
      problem = "The file '" + path + "' has the name of a folder of other files of this run.";
    }
    int main = path.length() - ProtectedAreas.LOST.length();
    boolean lost = path.endsWith(ProtectedAreas.LOST) && files.contains(path.substring(0, main));
    if (lost || losers.contains(path)) {
      problem = "The file '" + path + "' and another of this run differ only by '.lost',";
      problem += " which is reserved for lost protected areas.";
    }
    for (int slash = path.indexOf('/'); slash >= 0; slash = path.indexOf('/', slash + 1)) {
      if (files.contains(path.substring(0, slash))) {
        problem = "The file '" + path + "' is below '" + path.substring(0, slash);
        problem += "', which is a file of this run, not a folder.";
      }
    }
    return Optional.of(problem).filter(text -> !text.isEmpty());
  }
}
