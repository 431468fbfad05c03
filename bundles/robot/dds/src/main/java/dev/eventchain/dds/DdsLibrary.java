package dev.eventchain.dds;

import com.sun.jna.Library;
import com.sun.jna.Native;
import com.sun.jna.NativeLibrary;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The C library of Eclipse Cyclone DDS, loaded at most once per process and never unloaded. */
public final class DdsLibrary {

  private static final Rule UNAVAILABLE = Rule.error("dds.unavailable");
  private static final String SETTING = "EVENTCHAIN_LIBDDSC";
  private static final String HINT =
      "Set " + SETTING + " to a libddsc of Cyclone DDS 11.0.1, or unset it.";

  /** The library that this process has loaded; guarded by the class. */
  private static Optional<DdsLibrary> loaded = Optional.empty();

  private final Path path;
  private final Cyclone cyclone;

  DdsLibrary(Path path, Cyclone cyclone) {
    this.path = path;
    this.cyclone = cyclone;
  }

  /**
   * Loads the library, or returns the loaded one. The first call sends a message to this process
   * over loopback, to check the library's memory layout.
   *
   * @param path the library of the Python environment; empty for the one that the environment
   *     variable {@code EVENTCHAIN_LIBDDSC} names
   * @throws DiagnosticException {@code dds.unavailable} with the reason UNAVAILABLE: the library is
   *     missing, cannot be loaded, has another version, or this process has loaded another one
   */
  public static DdsLibrary load(Optional<Path> path) {
    return load(path, System.getenv());
  }

  static synchronized DdsLibrary load(Optional<Path> asked, Map<String, String> settings) {
    Path path = real(asked.or(() -> named(settings)).orElseThrow(DdsLibrary::missing));
    if (loaded.isEmpty()) {
      DdsLibrary library = new DdsLibrary(path, open(path));
      try {
        LayoutCheck.run(library);
      } catch (IllegalStateException | IllegalArgumentException e) {
        throw unavailable(path, path + " does not work as expected: " + e.getMessage());
      }
      loaded = Optional.of(library);
    } else if (!loaded.get().path.equals(path)) {
      throw unavailable(
          path, "This process already uses " + loaded.get().path + ", not " + path + ".");
    }
    return loaded.get();
  }

  private static Optional<Path> named(Map<String, String> settings) {
    String name = settings.getOrDefault(SETTING, "");
    return name.isEmpty() ? Optional.empty() : Optional.of(Path.of(name));
  }

  private static DiagnosticException missing() {
    return new DiagnosticException(
        DiagnosticException.Reason.UNAVAILABLE,
        Diagnostic.of(UNAVAILABLE, "No Cyclone DDS library was found.", SourceLocation.NONE)
            .withHint(HINT));
  }

  private static DiagnosticException unavailable(Path path, String message) {
    return new DiagnosticException(
        DiagnosticException.Reason.UNAVAILABLE,
        Diagnostic.of(UNAVAILABLE, message, SourceLocation.of(path)).withHint(HINT));
  }

  private static Path real(Path path) {
    try {
      if (Files.isRegularFile(path)) {
        return path.toRealPath();
      }
    } catch (IOException e) {
      throw unavailable(path, path + " cannot be read.");
    }
    throw unavailable(path, "The Cyclone DDS library, " + path + ", does not exist.");
  }

  private static Cyclone open(Path path) {
    Map<String, Object> options =
        Map.of(
            Library.OPTION_FUNCTION_MAPPER, Cyclone.NAMES, Library.OPTION_STRING_ENCODING, "UTF-8");
    try {
      if (Native.SIZE_T_SIZE != Long.BYTES) {
        throw unavailable(path, "Cyclone DDS is supported on 64-bit machines only.");
      }
      NativeLibrary library = NativeLibrary.getInstance(path.toString(), options);
      requireFunctions(path, library);
      Native.register(Samples.class, library);
      return Native.load(path.toString(), Cyclone.class, options);
    } catch (LinkageError e) { // of the library, or of JNA's own
      throw unavailable(path, path + " cannot be loaded: " + firstLine(e) + ".");
    }
  }

  /** Checks all functions at once; otherwise a missing one would show only when it is called. */
  private static void requireFunctions(Path path, NativeLibrary library) {
    List<Method> methods = new ArrayList<>(List.of(Cyclone.class.getDeclaredMethods()));
    methods.addAll(List.of(Samples.class.getDeclaredMethods()));
    for (Method method : methods) {
      if (java.lang.reflect.Modifier.isStatic(method.getModifiers())
          && !java.lang.reflect.Modifier.isNative(method.getModifiers())) {
        continue;
      }
      String name = Cyclone.NAMES.getFunctionName(library, method);
      try {
        library.getGlobalVariableAddress(name);
      } catch (UnsatisfiedLinkError e) {
        throw unavailable(path, path + " is not Cyclone DDS 11: it has no " + name + ".");
      }
    }
  }

  private static String firstLine(LinkageError problem) {
    return String.valueOf(problem.getMessage()).lines().findFirst().orElse("").strip();
  }

  /** Returns the path of the library. */
  public Path path() {
    return path;
  }

  Cyclone cyclone() {
    return cyclone;
  }
}
