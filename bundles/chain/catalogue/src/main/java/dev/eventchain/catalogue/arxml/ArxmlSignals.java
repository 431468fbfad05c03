package dev.eventchain.catalogue.arxml;

import dev.eventchain.catalogue.arxml.ArxmlLimits.NoNumberException;
import dev.eventchain.catalogue.network.NetworkSignal;
import dev.eventchain.catalogue.network.NetworkSignal.Coding;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** Makes signals of mappings of I-SIGNALs into PDUs. */
final class ArxmlSignals {

  /** Byte order in which a start is that of the most significant bit. */
  static final String BIG_ENDIAN = "MOST-SIGNIFICANT-BYTE-FIRST";

  private static final int LARGEST_START = 1 << 19;
  private static final int LONGEST = 64;

  /** Encodings of whole numbers without a sign. */
  private static final Set<String> UNSIGNED = Set.of("", "NONE", "BOOLEAN");

  private static final Set<String> MEANINGS = Set.of("SYSTEM-SIGNAL", "SYSTEM-SIGNAL-GROUP");

  private static final String INVALID = "invalid";

  private final ArxmlTree tree;
  private final ArxmlUnread unread;
  private final ArxmlUnits units;
  private final Map<String, Optional<ArxmlScaling>> scalings = new HashMap<>();

  /**
   * Properties of a value on the network and of the value that it stands for.
   *
   * @param name of the signal with that of its PDU, for findings
   */
  private record Properties(
      String name, Optional<ArxmlElement> network, Optional<ArxmlElement> physical) {

    List<ArxmlElement> all() {
      return Stream.of(network, physical).flatMap(Optional::stream).toList();
    }
  }

  ArxmlSignals(ArxmlTree tree, ArxmlUnread unread) {
    this.tree = tree;
    this.unread = unread;
    this.units = new ArxmlUnits(tree, unread);
  }

  /**
   * Reads a signal.
   *
   * @param message the name of its message
   * @param shift bits before its PDU in the message
   * @return empty for a group of signals, and for one that is not read
   * @throws NoNumberException if a number is none
   */
  Optional<NetworkSignal> of(ArxmlElement mapping, String message, int shift)
      throws NoNumberException {
    Optional<ArxmlElement> signal = tree.follow(mapping, Set.of("I-SIGNAL"), "I-SIGNAL-REF");
    if (signal.isEmpty()) {
      return Optional.empty();
    }
    Optional<ArxmlElement> meaning = tree.follow(signal.get(), MEANINGS, "SYSTEM-SIGNAL-REF");
    String name = message + "." + signal.get().name();
    Properties properties =
        new Properties(
            name,
            properties(signal.get(), "NETWORK-REPRESENTATION-PROPS", name),
            meaning.flatMap(it -> properties(it, "PHYSICAL-PROPS", name)));
    Optional<Integer> length = length(signal.get(), name);
    Optional<Encoding> encoding = encoding(signal.get(), properties, length.orElse(0));
    if (length.isEmpty() || encoding.isEmpty()) {
      return Optional.empty();
    }
    Optional<ArxmlScaling> scaling = scaling(properties, encoding.get());
    if (scaling.isEmpty()) {
      return Optional.empty();
    }
    unread.noteVariants(mapping, name);
    NetworkSignal read =
        signal(
            mapping, signal.get(), properties, length.get(), encoding.get(), scaling.get(), shift);
    describe(read, signal.get(), meaning, properties);
    return Optional.of(read);
  }

  /** Coding of a raw number. */
  private record Encoding(Coding coding, boolean signed) {

    BigDecimal step() {
      return coding == Coding.INTEGER ? BigDecimal.ONE : BigDecimal.ZERO;
    }
  }

  private NetworkSignal signal(
      ArxmlElement mapping,
      ArxmlElement signal,
      Properties properties,
      int length,
      Encoding encoding,
      ArxmlScaling scaling,
      int shift)
      throws NoNumberException {
    ArxmlElement start =
        mapping
            .first("START-POSITION")
            .orElseThrow(
                () ->
                    new NoNumberException(
                        "'" + properties.name() + "' has no START-POSITION.", mapping.location()));
    String unit = unit(properties);
    ArxmlLimits limits =
        limits(properties, encoding, scaling, unit)
            .and(scaling.limits().scaled(scaling.factor(), scaling.offset()));
    NetworkSignal.Layout layout =
        new NetworkSignal.Layout(
            shift + (int) ArxmlLimits.whole(start, LARGEST_START),
            length,
            mapping.text("PACKING-BYTE-ORDER").filter(BIG_ENDIAN::equals).isPresent(),
            encoding.signed(),
            scaling.factor(),
            scaling.offset(),
            limits.least(),
            limits.most());
    NetworkSignal read = new NetworkSignal(signal.name(), "", layout, unit, mapping.location());
    read.coding(encoding.coding());
    read.texts().putAll(scaling.texts());
    return read;
  }

  private void describe(
      NetworkSignal read,
      ArxmlElement signal,
      Optional<ArxmlElement> meaning,
      Properties properties)
      throws NoNumberException {
    String text = meaning.map(ArxmlElement::about).orElse("");
    read.comment(text.isEmpty() ? signal.about() : text);
    for (ArxmlElement each : properties.all()) {
      Optional<ArxmlElement> invalid =
          each.first("INVALID-VALUE", "NUMERICAL-VALUE-SPECIFICATION", "VALUE");
      if (invalid.isPresent()) {
        BigDecimal raw = ArxmlScaling.trimmed(ArxmlLimits.number(invalid.get()));
        read.texts().putIfAbsent(raw, INVALID);
      }
    }
    Optional<ArxmlElement> initial = signal.first("INIT-VALUE");
    if (initial.isPresent()) {
      Optional<ArxmlElement> value = constant(initial.get());
      if (value.isPresent()) {
        read.initial(ArxmlLimits.number(value.get()));
      } else {
        unread.note(ArxmlUnread.Kind.INITIAL, properties.name(), initial.get().location());
      }
    }
  }

  /** Returns the number of an initial value, which may be that of a constant. */
  private Optional<ArxmlElement> constant(ArxmlElement initial) {
    Optional<ArxmlElement> own = initial.first("NUMERICAL-VALUE-SPECIFICATION", "VALUE");
    return own.isPresent()
        ? own
        : tree.follow(
                initial, Set.of("CONSTANT-SPECIFICATION"), "CONSTANT-REFERENCE", "CONSTANT-REF")
            .flatMap(it -> it.first("VALUE-SPEC", "NUMERICAL-VALUE-SPECIFICATION", "VALUE"));
  }

  private Optional<ArxmlElement> properties(ArxmlElement element, String tag, String name) {
    List<ArxmlElement> all =
        element.all(tag, "SW-DATA-DEF-PROPS-VARIANTS", "SW-DATA-DEF-PROPS-CONDITIONAL");
    if (all.size() > 1) {
      unread.note(ArxmlUnread.Kind.VARIANT, name, all.get(1).location());
    }
    return all.stream().findFirst();
  }

  private Optional<Integer> length(ArxmlElement signal, String name) throws NoNumberException {
    Optional<ArxmlElement> stated = signal.first("LENGTH");
    long length = stated.isEmpty() ? 0 : ArxmlLimits.whole(stated.get(), Integer.MAX_VALUE);
    if (length < 1 || length > LONGEST) {
      unread.note(ArxmlUnread.Kind.LENGTH, name, signal.location());
      return Optional.empty();
    }
    return Optional.of((int) length);
  }

  private Optional<Encoding> encoding(ArxmlElement signal, Properties properties, int length) {
    Optional<ArxmlElement> type =
        properties.all().stream()
            .flatMap(it -> it.first("BASE-TYPE-REF").stream())
            .findFirst()
            .flatMap(it -> tree.follow(it, Set.of("SW-BASE-TYPE")));
    boolean stated =
        properties.all().stream().anyMatch(it -> it.first("BASE-TYPE-REF").isPresent());
    if (!stated && length > 1) {
      unread.note(ArxmlUnread.Kind.SIGN, properties.name(), signal.location());
    }
    String encoding = type.flatMap(it -> it.text("BASE-TYPE-ENCODING")).orElse("");
    boolean isList = signal.text("I-SIGNAL-TYPE").filter("ARRAY"::equals).isPresent();
    if (!isList && UNSIGNED.contains(encoding)) {
      return Optional.of(new Encoding(Coding.INTEGER, false));
    }
    if (!isList && encoding.equals("2C")) {
      return Optional.of(new Encoding(Coding.INTEGER, true));
    }
    if (!isList && encoding.equals("IEEE754")) {
      return Optional.of(new Encoding(length == 32 ? Coding.FLOAT : Coding.DOUBLE, true));
    }
    unread.note(ArxmlUnread.Kind.ENCODING, properties.name(), signal.location());
    return Optional.empty();
  }

  /** Returns the method of the value on the network, or else that of what it stands for. */
  private Optional<ArxmlElement> method(Properties properties) {
    return properties.all().stream()
        .flatMap(it -> it.first("COMPU-METHOD-REF").stream())
        .findFirst()
        .flatMap(it -> tree.follow(it, Set.of("COMPU-METHOD")));
  }

  private Optional<ArxmlScaling> scaling(Properties properties, Encoding encoding)
      throws NoNumberException {
    Optional<ArxmlElement> method = method(properties);
    if (method.isEmpty()) {
      return Optional.of(ArxmlScaling.PLAIN);
    }
    String key = method.get().path() + " " + encoding.step();
    if (!scalings.containsKey(key)) {
      // A method that cannot be read is reported for the first of its signals.
      scalings.put(key, Optional.empty());
      scalings.put(key, ArxmlScaling.of(method.get(), encoding.step(), unread));
    }
    return scalings.get(key);
  }

  /** Returns the unit of what a signal stands for, or else that of its method. */
  private String unit(Properties properties) throws NoNumberException {
    List<String> stated = new ArrayList<>();
    for (Optional<ArxmlElement> each :
        List.of(properties.physical(), properties.network(), method(properties))) {
      if (each.isPresent()) {
        units.of(each.get()).ifPresent(stated::add);
      }
    }
    if (new HashSet<>(stated).size() > 1) {
      unread.note(ArxmlUnread.Kind.UNITS, properties.name(), properties.all().get(0).location());
    }
    return stated.isEmpty() ? "" : stated.get(0);
  }

  /** Returns the limits of a signal's physical values that data constraints state. */
  private ArxmlLimits limits(
      Properties properties, Encoding encoding, ArxmlScaling scaling, String unit)
      throws NoNumberException {
    ArxmlLimits limits = ArxmlLimits.NONE;
    Map<String, ArxmlElement> constraints = new LinkedHashMap<>();
    for (ArxmlElement each : properties.all()) {
      tree.follow(each, Set.of("DATA-CONSTR"), "DATA-CONSTR-REF")
          .ifPresent(it -> constraints.put(it.path(), it));
    }
    BigDecimal step = scaling.factor().abs().multiply(encoding.step());
    for (ArxmlElement constraint : constraints.values()) {
      for (ArxmlElement rule : constraint.all("DATA-CONSTR-RULES", "DATA-CONSTR-RULE")) {
        for (ArxmlElement each : rule.all("INTERNAL-CONSTRS")) {
          ArxmlLimits raw = ArxmlLimits.of(each, encoding.step(), BigDecimal.ZERO);
          limits = limits.and(raw.scaled(scaling.factor(), scaling.offset()));
        }
        for (ArxmlElement each : rule.all("PHYS-CONSTRS")) {
          if (units.of(each).filter(it -> !it.equals(unit)).isPresent()) {
            unread.note(ArxmlUnread.Kind.CONSTRAINT, properties.name(), each.location());
          } else {
            limits = limits.and(ArxmlLimits.of(each, step, scaling.offset()));
          }
        }
      }
    }
    return limits;
  }
}
