package dev.eventchain.sandbox;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Eventchain's own Python: a virtual environment with pinned packages (NumPy, ruamel.yaml) in the
 * user's cache, based on this machine's Python 3.10 or newer.
 */
public final class PythonEnvironment {

  private final Path folder;
  private final String version;
  private final List<Path> installation;
  private final Optional<Path> cycloneDds;

  PythonEnvironment(
      Path folder, String version, List<Path> installation, Optional<Path> cycloneDds) {
    this.folder = folder;
    this.version = version;
    this.installation = List.copyOf(installation);
    this.cycloneDds = cycloneDds;
  }

  /**
   * Finds the environment, or creates it on first use (about ten seconds and network access; later
   * a few milliseconds). Safe for concurrent processes.
   *
   * <p>The base Python is {@code EVENTCHAIN_PYTHON} if that is set, else {@code python3} of the
   * {@code PATH}. The packages come from pip's index, or from the folder of wheels {@code
   * EVENTCHAIN_WHEELS} if that is set.
   *
   * @param progress receives lines for the user while the environment is created
   * @throws dev.eventchain.diagnostics.DiagnosticException {@code python.unavailable} with the
   *     reason UNAVAILABLE: there is no Python 3.10 or newer, it lacks its venv module, the
   *     packages are unavailable, or the cache cannot be written; {@code python.wheels.missing}:
   *     {@code EVENTCHAIN_WHEELS} lacks one; and as {@link Confinement#detect}
   */
  public static PythonEnvironment ensure(Consumer<String> progress) {
    Confinement unused = Confinement.detect(); // before a minute of downloads
    return new EnvironmentFinder(System.getenv(), progress).find();
  }

  /**
   * As {@link #ensure}, with Eclipse Cyclone DDS; a separate environment, so that simulations in
   * lock-step do not need it.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@link #ensure}, and {@code
   *     dds.unavailable} with the reason UNAVAILABLE: Cyclone DDS does not exist for this machine,
   *     or cannot be downloaded
   */
  public static PythonEnvironment ensureWithCycloneDds(Consumer<String> progress) {
    Confinement unused = Confinement.detect(); // before a minute of downloads
    return new EnvironmentFinder(System.getenv(), progress).findWithCycloneDds();
  }

  /**
   * Finds or creates an environment that has Ray, and not what components need: it starts no
   * component.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@link #ensure}, except for
   *     confinement, and {@code ray.unavailable} with the reason UNAVAILABLE: Ray does not exist
   *     for this machine, or cannot be downloaded
   */
  public static PythonEnvironment ensureWithRay(Consumer<String> progress) {
    return new EnvironmentFinder(System.getenv(), progress).findWithRay();
  }

  /**
   * Describes briefly what {@link #ensure} would do, without doing it: the version of Python, and
   * whether the packages are present or where they come from. If they are not present, pip
   * downloads them once into a temporary folder.
   *
   * @param progress receives lines for the user in the meantime
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@link #ensure} would
   */
  public static String outlook(Consumer<String> progress) {
    Confinement unused = Confinement.detect();
    return new EnvironmentFinder(System.getenv(), progress).outlook();
  }

  /**
   * As {@link #outlook}, for {@link #ensureWithCycloneDds}.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@code ensureWithCycloneDds}, except
   *     for a library that does not load on this system
   */
  public static String outlookWithCycloneDds(Consumer<String> progress) {
    Confinement unused = Confinement.detect();
    return new EnvironmentFinder(System.getenv(), progress).outlookWithCycloneDds();
  }

  /** Returns the Python executable of the environment. */
  public Path executable() {
    return folder.resolve("bin").resolve("python");
  }

  /** Returns the version of Python, such as {@code 3.11.7}. */
  public String version() {
    return version;
  }

  /**
   * Returns the library libddsc of Eclipse Cyclone DDS; empty unless the environment was created
   * with it. This Python has loaded it once as a check.
   */
  public Optional<Path> cycloneDds() {
    return cycloneDds;
  }

  /**
   * Returns the paths, besides the system's libraries, that a process must be able to read to run
   * this Python.
   */
  List<Path> installation() {
    return installation;
  }
}
