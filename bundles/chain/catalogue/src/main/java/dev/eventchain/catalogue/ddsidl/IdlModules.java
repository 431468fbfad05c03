package dev.eventchain.catalogue.ddsidl;

import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import dev.eventchain.catalogue.signal.CatalogueSignal.Role;
import dev.eventchain.catalogue.signal.CatalogueUnits;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The structures of a file line by line, in the layout of the export. */
final class IdlModules {

  private static final Pattern MODULE = Pattern.compile("module (?<name>\\w+)");
  private static final Pattern STRUCTURE = Pattern.compile("struct (?<name>\\w+)");
  private static final Pattern ENUMERATION =
      Pattern.compile("enum (?<name>\\w+)\\{(?<values>.*)};");
  private static final String NUMBER = "-?[0-9]+(?:\\.[0-9]+)?(?:[eE][-+]?[0-9]+)?";
  private static final Pattern RANGE =
      Pattern.compile(
          "@range\\(min=(?<least>NUMBER) ,max=(?<most>NUMBER)\\)".replace("NUMBER", NUMBER));
  private static final Pattern VALUE = Pattern.compile("(?<type>[\\w:<> ]+?) value(?: .*)?;");
  private static final Pattern FACT =
      Pattern.compile("(?://)?const string (?<name>\\w+) ?=\"(?<text>.*)\";");
  private static final Pattern NOTHING = Pattern.compile("\\{|//.*|@default.*|");

  private static final Map<String, String> TYPES =
      Map.ofEntries(
          Map.entry("boolean", "bool"),
          Map.entry("octet", "uint8"),
          Map.entry("short", "int16"),
          Map.entry("unsigned short", "uint16"),
          Map.entry("long", "int32"),
          Map.entry("unsigned long", "uint32"),
          Map.entry("long long", "int64"),
          Map.entry("unsigned long long", "uint64"),
          Map.entry("float", "float32"),
          Map.entry("double", "float64"),
          Map.entry("string", "string"));

  private final SourceText source;
  private final Consumer<Diagnostic> findings;
  private final Deque<String> modules = new ArrayDeque<>();
  private final Map<String, List<String>> enumerations = new HashMap<>();
  private final List<CatalogueSignal> signals = new ArrayList<>();
  private Optional<Structure> structure = Optional.empty();

  /** A structure while it is read. */
  private static final class Structure {
    private final String name;
    private final SourceLocation place;
    private final Map<String, String> facts = new HashMap<>();
    private String type = "";
    private OptionalDouble least = OptionalDouble.empty();
    private OptionalDouble most = OptionalDouble.empty();

    Structure(String name, SourceLocation place) {
      this.name = name;
      this.place = place;
    }
  }

  IdlModules(SourceText source, Consumer<Diagnostic> findings) {
    this.source = source;
    this.findings = findings;
  }

  /** Returns the signals; a line that is not read is a finding. */
  List<CatalogueSignal> read() {
    int number = 0;
    for (String line : source.text().lines().toList()) {
      number++;
      line(line.strip(), source.at(number, 1));
    }
    if (!modules.isEmpty() || structure.isPresent()) {
      find("The file ends inside of a module.", source.at(Math.max(1, number), 1));
    }
    return signals;
  }

  private void line(String line, SourceLocation place) {
    Matcher module = MODULE.matcher(line);
    Matcher begin = STRUCTURE.matcher(line);
    Matcher values = ENUMERATION.matcher(line);
    if (structure.isPresent()) {
      inStructure(structure.get(), line, place);
    } else if (module.matches()) {
      modules.addLast(plain(module.group("name")));
    } else if (begin.matches()) {
      structure = Optional.of(new Structure(plain(begin.group("name")), place));
    } else if (values.matches() && !modules.isEmpty()) {
      String name = modules.peekLast() + "::" + plain(values.group("name"));
      enumerations.put(name, List.of(values.group("values").split(",", -1)));
    } else if (line.equals("};") && !modules.isEmpty()) {
      modules.removeLast();
    } else if (!NOTHING.matcher(line).matches()) {
      find("This line is not read: `" + line + "`.", place);
    }
  }

  private void inStructure(Structure open, String line, SourceLocation place) {
    Matcher value = VALUE.matcher(line);
    Matcher fact = FACT.matcher(line);
    Matcher range = RANGE.matcher(line);
    if (line.equals("};")) {
      signal(open).ifPresent(signals::add);
      structure = Optional.empty();
    } else if (fact.matches()) {
      open.facts.put(fact.group("name"), fact.group("text"));
    } else if (range.matches()) {
      open.least = OptionalDouble.of(Double.parseDouble(range.group("least")));
      open.most = OptionalDouble.of(Double.parseDouble(range.group("most")));
    } else if (value.matches()) {
      open.type = value.group("type").strip();
    } else if (!NOTHING.matcher(line).matches()) {
      find("This line is not read: `" + line + "`.", place);
    }
  }

  private Optional<CatalogueSignal> signal(Structure read) {
    String path =
        Stream.concat(modules.stream(), Stream.of(read.name)).collect(Collectors.joining("."));
    String role = read.facts.getOrDefault("type", "").toUpperCase(Locale.ROOT);
    String element = read.type.replaceFirst("^sequence<(.*)>$", "$1");
    List<String> allowed = enumerations.getOrDefault(plainType(element), List.of());
    Optional<String> type =
        allowed.isEmpty() ? Optional.ofNullable(TYPES.get(element)) : Optional.of("string");
    if (type.isEmpty() || Stream.of(Role.values()).noneMatch(it -> it.name().equals(role))) {
      String what = type.isEmpty() ? "'" + read.type + "' is not a datatype." : "There is no type.";
      find("'" + path + "' is not read: " + what, read.place);
      return Optional.empty();
    }
    boolean list = !element.equals(read.type);
    return Optional.of(
        new CatalogueSignal(
            path,
            Role.valueOf(role),
            list ? listOf(type.get()) : type,
            CatalogueUnits.of(read.facts.getOrDefault("unit", "")),
            read.least,
            read.most,
            allowed,
            List.of(),
            read.facts.getOrDefault("description", ""),
            List.of(),
            read.place));
  }

  private static Optional<String> listOf(String type) {
    return type.equals("string") || type.equals("bool")
        ? Optional.empty()
        : Optional.of(type + "[]");
  }

  /** Returns a name without the underscore that keeps it from being a keyword. */
  private static String plain(String name) {
    return name.replaceFirst("^_", "");
  }

  private static String plainType(String type) {
    return Stream.of(type.split("::", -1)).map(IdlModules::plain).collect(Collectors.joining("::"));
  }

  private void find(String message, SourceLocation place) {
    findings.accept(Diagnostic.of(CatalogueRules.ENTRY, message, place));
  }
}
