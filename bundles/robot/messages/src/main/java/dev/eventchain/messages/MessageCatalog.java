package dev.eventchain.messages;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Catalog of the available message types: the standard ones of a release of ROS 2, and those in
 * folders of the user. Definitions are read on demand.
 */
public final class MessageCatalog {

  private static final String SUFFIX = ".msg";
  private static final String IDL_SUFFIX = ".idl";

  /** Prefix of the name of a type, in the format of recordings. */
  static final String HEADING = "MSG: ";

  /** Separator of two definitions, in the format of recordings. */
  static final String SEPARATOR = "=".repeat(80) + "\n";

  private final RosDistribution distribution;
  private final Map<String, String> standard;
  private final List<Path> folders;
  private final SortedMap<String, Path> files = new TreeMap<>();
  private final Map<String, Path> filesBeside = new HashMap<>();
  private final SortedMap<String, Path> filesOfServices = new TreeMap<>();
  private final List<Path> misplaced = new ArrayList<>();
  private final Map<String, MessageType> types = new HashMap<>();

  private MessageCatalog(
      RosDistribution distribution, Map<String, String> standard, List<Path> folders) {
    this.distribution = distribution;
    this.standard = standard;
    this.folders = folders;
    folders.forEach(this::list);
  }

  /** As {@link #of(RosDistribution, Collection)}, of the default release. */
  public static MessageCatalog of(Collection<Path> folders) {
    return of(RosDistribution.DEFAULT, folders);
  }

  /**
   * Returns a catalog of the standard types and those in folders.
   *
   * @param distribution the release that defines the standard types
   * @param folders folders with {@code PACKAGE/msg/NAME.msg} or {@code NAME.idl}, or both with
   *     equal content, and {@code PACKAGE/srv/NAME.srv}, or links to such files or folders; at any
   *     depth below a folder with {@code package.xml}, as in a colcon workspace (see {@link
   *     RosFolder}). Later folders override earlier ones, and all override standard types
   * @throws DiagnosticException {@code file.unreadable}: a folder is missing or cannot be listed
   */
  public static MessageCatalog of(RosDistribution distribution, Collection<Path> folders) {
    return new MessageCatalog(distribution, StandardTypes.of(distribution), List.copyOf(folders));
  }

  /**
   * Returns a catalog of the standard types of the default release and the given definitions.
   *
   * @param texts definitions by full name; they override standard types
   */
  public static MessageCatalog ofTexts(Map<String, String> texts) {
    Map<String, String> all = new HashMap<>(StandardTypes.of(RosDistribution.DEFAULT));
    all.putAll(texts);
    return new MessageCatalog(RosDistribution.DEFAULT, all, List.of());
  }

  private void list(Path folder) {
    Set<String> ofThisFolder = new HashSet<>();
    try {
      RosFolder found = RosFolder.list(folder);
      for (Path file : found.files()) {
        if (isDefinition(file)) {
          take(file, found.nameOf(file, folder), ofThisFolder);
        }
      }
    } catch (IOException e) {
      throw FileRules.refusal("The folder of message definitions", folder, e);
    }
  }

  private void take(Path file, String name, Set<String> ofThisFolder) {
    String type = name.substring(0, name.length() - SUFFIX.length());
    boolean isMessage = name.endsWith(SUFFIX) || name.endsWith(IDL_SUFFIX);
    if (name.endsWith(ServiceParser.SUFFIX) && ServiceParser.isService(type)) {
      ServiceParser.messages(type).forEach(part -> filesOfServices.put(part, file));
    } else if (isMessage && RosNames.isFullMessageType(type)) {
      place(type, file, ofThisFolder.add(type));
    } else {
      misplaced.add(file);
    }
  }

  /** Registers a file; NAME.msg comes after NAME.idl. */
  private void place(String type, Path file, boolean isFirst) {
    Path before = files.put(type, file);
    if (isFirst || before == null) {
      filesBeside.remove(type);
    } else {
      filesBeside.put(type, before);
    }
  }

  /** Returns whether a file has the name of a definition, ignoring case. */
  private static boolean isDefinition(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    return Stream.of(SUFFIX, IDL_SUFFIX, ServiceParser.SUFFIX).anyMatch(name::endsWith);
  }

  /** Returns the folders of the user, as they were given. */
  public List<Path> folders() {
    return folders;
  }

  /** Returns the file of the user that defines a type, if there is one. */
  public Optional<Path> file(String type) {
    return Optional.ofNullable(files.get(RosNames.fullMessageType(type)));
  }

  /** Returns the files of the user that define services, by the full names of these. */
  public SortedMap<String, Path> services() {
    SortedMap<String, Path> services = new TreeMap<>();
    filesOfServices.forEach((part, file) -> services.put(ServiceParser.serviceOf(part), file));
    return services;
  }

  /** Returns the full names of all types. */
  public SortedSet<String> names() {
    SortedSet<String> names = new TreeSet<>(standard.keySet());
    names.addAll(files.keySet());
    return names;
  }

  /** Returns the full names of the types in the user's folders. */
  public SortedSet<String> ownNames() {
    return new TreeSet<>(files.keySet());
  }

  /**
   * Returns all errors of the definitions in the user's folders, and warnings about definitions
   * that are unusable because of their place or name ({@code message.place}).
   */
  public List<Diagnostic> diagnostics() {
    Set<Diagnostic> found = new TreeSet<>();
    for (Path file : misplaced) {
      found.add(
          Diagnostic.of(
                  MessageRules.PLACE,
                  "This is not read: no message type has this file.",
                  SourceLocation.of(file))
              .withHint(
                  "Name it %s, within the folder of definitions or of workspaces; there, PACKAGE is a folder with a package.xml."
                      .formatted(
                          file.toString().endsWith(ServiceParser.SUFFIX)
                              ? "PACKAGE/srv/NAME.srv"
                              : "PACKAGE/msg/NAME.msg, or .idl")));
    }
    for (String name : ownAndOfServices()) {
      try {
        find(name);
      } catch (DiagnosticException e) {
        found.addAll(e.diagnostics());
      }
    }
    return List.copyOf(found);
  }

  /** Returns the types in the user's folders, with the requests and responses of services. */
  private SortedSet<String> ownAndOfServices() {
    SortedSet<String> names = new TreeSet<>(files.keySet());
    names.addAll(filesOfServices.keySet());
    return names;
  }

  /**
   * Returns a type by its name, {@code sensor_msgs/msg/LaserScan} or {@code sensor_msgs/LaserScan}.
   *
   * @return empty if there is no such type
   * @throws DiagnosticException its definition, or one that it uses, is invalid: {@code
   *     message.syntax}, {@code message.name.duplicate}, {@code message.value}, {@code
   *     message.type.unknown}, {@code message.cycle}, {@code message.conflict}; or its file cannot
   *     be read
   */
  public synchronized Optional<MessageType> find(String name) {
    String fullName = RosNames.fullMessageType(name);
    if (!standard.containsKey(fullName)
        && !files.containsKey(fullName)
        && !filesOfServices.containsKey(fullName)) {
      return Optional.empty();
    }
    return Optional.of(type(fullName, new LinkedHashSet<>()));
  }

  /**
   * Returns the definition of a type and of the types that it uses, in the format of recordings.
   * Each of the others follows a line of 80 equals signs and one with {@code MSG:} and its name.
   */
  public synchronized String text(MessageType type) {
    StringBuilder text = new StringBuilder(ownText(type));
    Set<MessageType> used = new LinkedHashSet<>();
    addUsed(type, used);
    for (MessageType other : used) {
      String name = other.name().replace("/msg/", "/");
      text.append(SEPARATOR).append(HEADING).append(name).append('\n').append(ownText(other));
    }
    return text.toString();
  }

  /**
   * Returns the types in the user's folders in the format of the Python runtime: a JSON object with
   * their fields, defaults and constants by full name; a service is the types of its request and
   * its response, {@code std_srvs/srv/SetBool_Request}. Next to them are the standard types that
   * the default release, which the runtime knows, does not have or has differently.
   *
   * @throws DiagnosticException as {@link #find}, for the first invalid one
   */
  public String ownDefinitions() {
    SortedSet<String> unknown = new TreeSet<>(StandardTypes.different(distribution));
    unknown.addAll(ownAndOfServices());
    return definitions(unknown);
  }

  /** Returns the definitions of types in the format of {@link #ownDefinitions}. */
  String definitions(Collection<String> types) {
    return DefinitionsJson.of(types.stream().map(name -> find(name).orElseThrow()).toList());
  }

  /**
   * Returns the beginning of a hint about a type or field that does not exist: a sentence and a
   * space if another release of ROS 2 has it, else nothing.
   *
   * @param path the path of a field; empty for the type itself
   */
  public String hintOfDistribution(String type, String path) {
    boolean isOwn = files.containsKey(RosNames.fullMessageType(type));
    return otherDistribution(
            type, found -> !isOwn && (path.isEmpty() || found.resolve(path).type().isPresent()))
        .map(
            other ->
                ("ROS 2 %s has it, and the messages used here are those of %s: see 'ros_distro' in"
                        + " eventchain.yaml. ")
                    .formatted(other, distribution))
        .orElse("");
  }

  /** Returns the first other release of ROS 2 with a standard type as wanted, if there is one. */
  public Optional<RosDistribution> otherDistribution(String type, Predicate<MessageType> wanted) {
    return Arrays.stream(RosDistribution.values())
        .filter(other -> other != distribution)
        .filter(other -> of(other, List.of()).find(type).filter(wanted).isPresent())
        .findFirst();
  }

  private String ownText(MessageType type) {
    Path file = files.get(type.name());
    if (file != null && file.toString().endsWith(IDL_SUFFIX)) {
      return type.fields().stream()
          .map(field -> field.type().toString().replace("/msg/", "/") + " " + field.name() + "\n")
          .collect(Collectors.joining());
    }
    String text = source(type.name()).text().replace("\r\n", "\n");
    return text.isEmpty() || text.endsWith("\n") ? text : text + "\n";
  }

  private static void addUsed(MessageType type, Set<MessageType> used) {
    for (MessageType.Field field : type.fields()) {
      field.type().message().filter(used::add).ifPresent(inner -> addUsed(inner, used));
    }
  }

  private MessageType type(String name, Set<String> users) {
    MessageType known = types.get(name);
    if (known == null) {
      known = link(definition(name), users);
      types.put(name, known);
    }
    return known;
  }

  private Definition definition(String name) {
    Path service = filesOfServices.get(name);
    if (service != null) {
      return ServiceParser.parse(name, SourceText.read(service)).orThrow();
    }
    Path file = files.get(name);
    if (file == null) {
      return MessageParser.parse(name, SourceText.of(name, standard.get(name))).orThrow();
    }
    Definition definition = definition(name, file);
    Path beside = filesBeside.get(name);
    if (beside != null && !definition.saysTheSameAs(definition(name, beside))) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
                  MessageRules.CONFLICT,
                  (file.getParent().equals(beside.getParent())
                          ? file.getFileName() + " next to this file"
                          : SourceLocation.of(file).file())
                      + " defines "
                      + name
                      + " differently.",
                  SourceLocation.of(beside))
              .withHint("Remove one of them, or regenerate it from the other."));
    }
    return definition;
  }

  private static Definition definition(String name, Path file) {
    SourceText source = SourceText.read(file);
    boolean isIdl = file.toString().endsWith(IDL_SUFFIX);
    Definition read = isIdl ? IdlParser.parse(name, source) : MessageParser.parse(name, source);
    return read.orThrow();
  }

  private SourceText source(String name) {
    Path file = files.get(name);
    return file == null ? SourceText.of(name, standard.get(name)) : SourceText.read(file);
  }

  private MessageType link(Definition definition, Set<String> users) {
    List<Diagnostic> problems = new ArrayList<>();
    List<MessageType.Field> fields = new ArrayList<>();
    users.add(definition.name());
    for (Definition.Member field : definition.fields()) {
      Optional<FieldType> type = fieldType(field, users, problems);
      type.ifPresent(
          found ->
              fields.add(
                  new MessageType.Field(field.name(), found, Optional.ofNullable(field.value()))));
    }
    users.remove(definition.name());
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    List<MessageType.Constant> constants = new ArrayList<>();
    for (Definition.Member constant : definition.constants()) {
      constants.add(new MessageType.Constant(constant.name(), constant.type(), constant.value()));
    }
    return new MessageType(definition.name(), fields, constants);
  }

  private Optional<FieldType> fieldType(
      Definition.Member field, Set<String> users, List<Diagnostic> problems) {
    FieldType type = field.type();
    String base = field.base();
    if (type.kind() != FieldType.Kind.MESSAGE) {
      return Optional.of(type);
    }
    if (users.contains(base)) {
      String message = "'" + field.name() + "' makes " + base + " contain itself.";
      problems.add(Diagnostic.of(MessageRules.CYCLE, message, field.place()));
      return Optional.empty();
    }
    if (!standard.containsKey(base) && !files.containsKey(base)) {
      problems.add(unknown(field));
      return Optional.empty();
    }
    try {
      return Optional.of(
          new FieldType(type.kind(), Optional.of(type(base, users)), type.shape(), type.size(), 0));
    } catch (DiagnosticException e) {
      problems.addAll(e.diagnostics());
      return Optional.empty();
    }
  }

  private Diagnostic unknown(Definition.Member field) {
    String message = "There is no message type " + field.base() + ".";
    String place = "Put its definition into PACKAGE/msg/NAME.msg, or .idl, next to the others.";
    return Diagnostic.of(MessageRules.TYPE_UNKNOWN, message, field.place())
        .withHint(hintOfDistribution(field.base(), "") + place);
  }
}
