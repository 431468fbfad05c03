package dev.eventchain.simulation.node;

import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;

/**
 * Files that are loaded instead of those of a package.
 *
 * @param files the files of components, and of nodes that are hosted as they are, by the names of
 *     the components
 * @param folders folders with modules that components import instead of those beside them, by the
 *     names of the components
 * @param modules files of modules that nodes which are hosted as they are import, by the paths of
 *     these modules in the folder of the package
 */
public record Replacements(
    Map<String, Path> files, Map<String, Path> folders, Map<String, Path> modules) {

  /** The package as it is. */
  public static final Replacements NONE = new Replacements(Map.of(), Map.of(), Map.of());

  /** Copies the maps. */
  public Replacements {
    files = Map.copyOf(files);
    folders = Map.copyOf(folders);
    modules = Map.copyOf(modules);
  }

  /** Replaces the file of a component or node. */
  public static Replacements of(String component, Path file) {
    return new Replacements(Map.of(component, file), Map.of(), Map.of());
  }

  /** Returns these replacements with others, which come first. */
  public Replacements with(Replacements others) {
    return new Replacements(
        together(files, others.files),
        together(folders, others.folders),
        together(modules, others.modules));
  }

  private static Map<String, Path> together(Map<String, Path> all, Map<String, Path> first) {
    Map<String, Path> both = new TreeMap<>(all);
    both.putAll(first);
    return both;
  }
}
