package dev.eventchain.pipeline.stage;

import java.nio.file.Path;

/**
 * Names of the sources of a stage, independent of the folders of project and output: {@code
 * project:requirements.md}, {@code output:chain.json}, {@code setting:frequency}.
 */
public final class SourceName {

  private static final String OUTPUT = "output:";
  private static final String PROJECT = "project:";
  private static final String SETTING = "setting:";

  private SourceName() {}

  public static String of(Path file, RunContext run) {
    Path place = absolute(file);
    Path output = absolute(run.options().output());
    Path project = absolute(run.project().folder());
    if (place.startsWith(output)) {
      return OUTPUT + shown(output.relativize(place));
    }
    return place.startsWith(project) ? PROJECT + shown(project.relativize(place)) : shown(place);
  }

  static String ofSetting(String name) {
    return SETTING + name;
  }

  static boolean isSetting(String source) {
    return source.startsWith(SETTING);
  }

  /** Returns whether a source belongs to the project or its output folder. */
  static boolean isInside(String source) {
    return source.startsWith(OUTPUT) || source.startsWith(PROJECT);
  }

  /** Returns the file of a source. */
  public static Path file(String source, RunContext run) {
    if (source.startsWith(OUTPUT)) {
      return run.file(source.substring(OUTPUT.length()));
    } else if (source.startsWith(PROJECT)) {
      return run.project().folder().resolve(source.substring(PROJECT.length()));
    }
    return source.startsWith(SETTING) ? run.project().configurationFile() : Path.of(source);
  }

  /** Returns the source for people, who also see the file's location. */
  public static String words(String source) {
    return source.startsWith(SETTING)
        ? "the setting '" + source.substring(SETTING.length()) + "'"
        : source.substring(source.startsWith("/") ? 0 : source.indexOf(':') + 1);
  }

  private static Path absolute(Path path) {
    return path.toAbsolutePath().normalize();
  }

  private static String shown(Path path) {
    return path.toString().replace('\\', '/');
  }
}
