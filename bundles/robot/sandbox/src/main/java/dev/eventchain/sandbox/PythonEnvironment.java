package dev.eventchain.sandbox;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Eventchain's own Python: a virtual environment with pinned packages (NumPy, rosbags), in the
 * user's cache, built on the Python 3.10 or newer of this machine.
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
   * Finds the environment, and creates it if it is not there yet (about ten seconds and the network
   * once; a few milliseconds after that). Safe when several processes do it at the same time.
   *
   * <p>The Python to build on is {@code EVENTCHAIN_PYTHON} if that is set, else {@code python3} of
   * the {@code PATH}. The packages come from pip's index, or from the folder of wheels {@code
   * EVENTCHAIN_WHEELS} if that is set.
   *
   * @param progress gets lines for people while the environment is made
   * @throws dev.eventchain.diagnostics.DiagnosticException {@code python.unavailable} with the
   *     reason UNAVAILABLE: there is no Python 3.10 or newer, it lacks its venv module, the
   *     packages cannot be had, or the cache cannot be written; {@code python.wheels.missing}:
   *     {@code EVENTCHAIN_WHEELS} lacks one; and as {@link Confinement#detect}
   */
  public static PythonEnvironment ensure(Consumer<String> progress) {
    Confinement unused = Confinement.detect(); // before a minute of downloads
    return new EnvironmentFinder(System.getenv(), progress).find();
  }

  /**
   * As {@link #ensure}, with Eclipse Cyclone DDS; an environment of its own, so that simulations in
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
   * Says in a few words what {@link #ensure} will do, which this does not: the version of Python,
   * and whether the packages are there or where they will come from. If they are not there, pip has
   * fetched them once into a folder that is removed again.
   *
   * @param progress gets lines for people in the meantime
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@link #ensure} would
   */
  public static String outlook(Consumer<String> progress) {
    Confinement unused = Confinement.detect();
    return new EnvironmentFinder(System.getenv(), progress).outlook();
  }

  /**
   * As {@link #outlook}, for {@link #ensureWithCycloneDds}.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException as that would, unless the library turns
   *     out not to fit the system when it is loaded
   */
  public static String outlookWithCycloneDds(Consumer<String> progress) {
    Confinement unused = Confinement.detect();
    return new EnvironmentFinder(System.getenv(), progress).outlookWithCycloneDds();
  }

  /** The Python of the environment. */
  public Path executable() {
    return folder.resolve("bin").resolve("python");
  }

  /** The version of Python, such as {@code 3.11.7}. */
  public String version() {
    return version;
  }

  /**
   * The library libddsc of Eclipse Cyclone DDS; empty unless the environment was made with it. It
   * has been loaded once, by this Python.
   */
  public Optional<Path> cycloneDds() {
    return cycloneDds;
  }

  /** What a process has to be able to read to run this Python, besides the system's libraries. */
  List<Path> installation() {
    return installation;
  }
}
