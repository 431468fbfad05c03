package dev.eventchain.pipeline.stage;

import static java.util.stream.Collectors.toSet;

import dev.eventchain.diagnostics.ContentHash;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.Sha256;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectSettings;
import dev.eventchain.project.RequirementSources;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * A hash of all inputs of a stage: values, files and the program itself; and of each source of its
 * results, so that a later stage can detect changed sources. The program, the language model and
 * its recordings are inputs but not sources of results.
 */
public final class Fingerprint {

  /** The content of a missing source. */
  public static final String ABSENT = "absent";

  private static final String OWN_JARS = "eventchain-";

  /** The build of this program. */
  public static final String PROGRAM = program();

  private final RunContext run;
  private final Sha256 digest = new Sha256();
  private final SortedMap<String, String> sources = new TreeMap<>();
  private String value = "";

  public Fingerprint(RunContext run) {
    this.run = run;
    add(PROGRAM);
  }

  /** Adds a value that is not a source. */
  public Fingerprint add(Object value) {
    byte[] bytes = String.valueOf(value).getBytes(StandardCharsets.UTF_8);
    digest.add(bytes.length + ":").add(bytes);
    return this;
  }

  /** Adds a value of the project's configuration. */
  public Fingerprint addSetting(String name, Object value) {
    sources.put(SourceName.ofSetting(name), String.valueOf(value));
    return add(name).add(value);
  }

  /** Adds a file's name and content; a missing file has a special content. */
  public Fingerprint addFile(Path file) {
    String content = contentOf(file);
    sources.put(SourceName.of(file, run), content);
    return add(file.getFileName()).add(content);
  }

  /** Adds files in the given order, which the caller fixes. */
  public Fingerprint addFiles(Collection<Path> files) {
    add(files.size());
    files.forEach(this::addFile);
    return this;
  }

  /** Adds the requirements: the files of all sources, and what counts of them. */
  public Fingerprint addRequirements() {
    RequirementSources named = run.project().requirementSources();
    if (!named.isEmpty()) {
      addSetting("requirements", named.asValue());
    }
    return addFiles(run.project().requirementFiles());
  }

  /** Adds the definitions of the messages: the release of ROS 2, and the project's files. */
  public Fingerprint addMessages() {
    return addSetting(ProjectSettings.DISTRIBUTION, run.project().distribution().id())
        .addFiles(run.project().messageFiles());
  }

  /** Adds the node of a network that the software is, if the project names one. */
  public Fingerprint addNode() {
    run.project()
        .catalogue()
        .flatMap(it -> it.source().node())
        .ifPresent(node -> addSetting("catalogue.node", node));
    return this;
  }

  /** Adds files that are inputs but not sources. */
  public Fingerprint addMeans(Collection<Path> files) {
    add(files.size());
    files.forEach(file -> add(file.getFileName()).add(contentOf(file)));
    return this;
  }

  /** Returns the hash in hexadecimal. Nothing can be added afterwards. */
  public String value() {
    if (value.isEmpty()) {
      value = digest.hex();
    }
    return value;
  }

  /**
   * Returns the known sources by {@link SourceName}, each with a hash of its content, or its value.
   */
  public SortedMap<String, String> sources() {
    return sources;
  }

  /**
   * Returns the sources of a result: the known ones, and the files that the work turned out to
   * read.
   *
   * @param outputs the files that it has written, relative to the output folder, which are no
   *     sources of it
   */
  public SortedMap<String, String> sources(Collection<Path> read, Collection<String> outputs) {
    Set<String> written =
        outputs.stream().map(name -> SourceName.of(run.file(name), run)).collect(toSet());
    SortedMap<String, String> all = new TreeMap<>(sources);
    for (Path file : read) {
      String name = SourceName.of(file, run);
      if (!written.contains(name) && !all.containsKey(name)) {
        String content = contentOf(file);
        // Temporary files are gone by now.
        if (SourceName.isInside(name) || !content.equals(ABSENT)) {
          all.put(name, content);
        }
      }
    }
    return all;
  }

  /** Returns the current sources: the known ones, and the files that a record names. */
  public SortedMap<String, String> sources(StageRecord record) {
    List<Path> files =
        record.sources().keySet().stream()
            .filter(source -> !SourceName.isSetting(source))
            .map(source -> SourceName.file(source, run))
            .toList();
    return sources(files, List.of());
  }

  /** Returns whether a record is about the current inputs, including what the stage has read. */
  public boolean isOf(StageRecord record) {
    return record.key().equals(value()) && record.sources().equals(sources(record));
  }

  /** Returns the hash of a file's content; a dangling link exists, but cannot be read. */
  public static String contentOf(Path file) {
    try {
      return ProjectFolder.isAbsent(file) ? ABSENT : ContentHash.hex(Files.readAllBytes(file));
    } catch (IOException e) {
      throw FileRules.refusal("The file", file, e);
    }
  }

  /**
   * Returns the build of the program, because another one may treat the same files differently: the
   * content of its own jars, wherever and whenever they were unpacked, and the names and sizes of
   * the others, which have their version in their name.
   */
  private static String program() {
    StringBuilder program = new StringBuilder();
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      File file = new File(entry);
      program.append(file.getName()).append('\n');
      if (file.isFile()) {
        boolean isOwn = file.getName().startsWith(OWN_JARS);
        program.append(isOwn ? contentOf(file.toPath()) : file.length()).append('\n');
      }
    }
    return Sha256.of(program.toString()).hex();
  }
}
