package dev.eventchain.templates;

import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;

/** Template modules that ship with the program, in sets: one for each middleware. */
public final class ShippedTemplates {

  /** Default template set. */
  public static final String DEFAULT = "ros2-python";

  private static final SortedSet<String> SETS = new TreeSet<>(Set.of(DEFAULT, "cyclonedds-python"));

  /** Templates about chains that are no middleware: their main modules are called so. */
  private static final Set<String> FORMATS = Set.of("nodl");

  /** Folder of modules that several sets share. */
  private static final String SHARED = "python";

  private ShippedTemplates() {}

  /** Returns the names of the sets for a middleware, in order. */
  public static SortedSet<String> sets() {
    return new TreeSet<>(SETS);
  }

  /** Returns whether there is a template about any chain with that name, other than a set. */
  public static boolean isFormat(String name) {
    return FORMATS.contains(name);
  }

  /**
   * Returns a resolver of modules for one compilation. {@code ros2_python::node} is in the set
   * {@code ros2-python}, and so are its unqualified imports.
   *
   * @param first the set for unqualified names until another set is named
   */
  public static Function<String, Optional<SourceText>> modules(String first) {
    AtomicReference<String> set = new AtomicReference<>(first);
    return name -> {
      int qualifier = name.lastIndexOf("::");
      String module = qualifier < 0 ? name : name.substring(qualifier + 2);
      if (qualifier < 0) {
        return module(set.get(), module).or(() -> module(SHARED, module));
      }
      String folder = name.substring(0, qualifier).replace('_', '-');
      if (SETS.contains(folder)) {
        set.set(folder);
      }
      return module(folder, module);
    };
  }

  /**
   * Returns a module.
   *
   * @param set a folder of {@code templates/}
   * @param module its name in that folder
   * @return the module; empty if there is none
   */
  public static Optional<SourceText> module(String set, String module) {
    if (!(set + module).matches("[A-Za-z0-9_-]+")) {
      return Optional.empty();
    }
    String name = "templates/" + set + "/" + module + ".mtl";
    try (InputStream stream = ShippedTemplates.class.getResourceAsStream("/" + name)) {
      return stream == null
          ? Optional.empty()
          : Optional.of(
              SourceText.of(name, new String(stream.readAllBytes(), StandardCharsets.UTF_8)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
