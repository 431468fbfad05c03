package dev.eventchain.simulation.scenario;

import com.fasterxml.jackson.databind.node.BigIntegerNode;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.NumericNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.openscenario.document.ParameterDeclaration;
import dev.eventchain.openscenario.document.ScenarioFile;
import dev.eventchain.openscenario.document.Variations;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * Variations of a file in OpenSCENARIO XML: of a file of distributions, the parameters that differ
 * between its cases; of a scenario, the numbers that a constraint bounds on both sides.
 *
 * @param scenario the file of the scenario
 * @param fixed values of parameters that are the same in all cases, but not those of the scenario
 * @param parameters what varies, in the order of the file; empty if nothing does
 * @param rows the values of the parameters in each case; empty if all combinations are meant
 * @param declared the values of all parameters of the scenario, as it writes them
 */
public record VariedScenario(
    Path scenario,
    Map<String, String> fixed,
    List<Parameter> parameters,
    List<List<String>> rows,
    Map<String, String> declared) {

  /** Digits of a number with which sums are computed at once. */
  private static final int MOST_DIGITS = 400;

  /** Values of a parameter of a whole type that a campaign goes through. */
  private static final int MOST_WHOLE = 1000;

  /**
   * A parameter that varies.
   *
   * @param usual its value where nothing varies
   * @param values as they are written; two bounds of all values between them for a range
   */
  public record Parameter(String name, String usual, List<String> values, boolean isRange) {

    /** Copies the values. */
    public Parameter {
      values = List.copyOf(values);
    }

    /** Returns whether all values are numbers, which those of a factor are. */
    public boolean isNumeric() {
      return values.stream().allMatch(value -> number(value).isPresent());
    }

    /** Returns the values as numbers, which they have to be. */
    public List<NumericNode> numbers() {
      return values.stream().map(value -> node(number(value).orElseThrow())).toList();
    }
  }

  /** Copies the lists. */
  public VariedScenario {
    parameters = List.copyOf(parameters);
    rows = List.copyOf(rows);
    declared = Collections.unmodifiableMap(new LinkedHashMap<>(declared));
  }

  /**
   * Reads a file.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException with all problems of the file
   */
  public static VariedScenario read(Path file) {
    ScenarioFile read = ScenarioFile.read(file, file.toAbsolutePath().getRoot());
    return read.kind() == ScenarioFile.Kind.DISTRIBUTION
        ? of(Variations.of(read))
        : new VariedScenario(
            file,
            Map.of(),
            read.parameters().stream().flatMap(each -> bounded(each).stream()).toList(),
            List.of(),
            declared(read));
  }

  private static Map<String, String> declared(ScenarioFile scenario) {
    Map<String, String> declared = new LinkedHashMap<>();
    scenario.parameters().forEach(each -> declared.put(each.name(), each.value()));
    return declared;
  }

  /** Returns the name of a scenario that plays a file. */
  public static String nameOf(Path file) {
    return ScenarioFiles.nameOf(file);
  }

  /**
   * Returns a scenario that plays the one that varies, with the usual values of what varies.
   *
   * @param path of the file, as the scenario names it
   * @param accept what is required: {@code KEY} or {@code KEY=NUMBER} each
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) if nothing is required
   */
  public ObjectNode written(String path, List<String> accept) {
    ScenarioFiles.requireAny(scenario, accept);
    return written(path, accept, Set.of());
  }

  /**
   * As {@link #written(String, List)}, with the values that more of its parameters have, as far as
   * they are numbers: a factor replaces them. What is required may be said elsewhere.
   */
  public ObjectNode written(String path, List<String> accept, Set<String> more) {
    ObjectNode written = ScenarioFiles.written(scenario, path, accept);
    ObjectNode values = ((ObjectNode) written.get(OpenScenarioReader.KEY)).putObject("parameters");
    fixed.forEach(
        (name, value) -> {
          Optional<BigDecimal> number = number(value).filter(it -> more.contains(name));
          number.ifPresentOrElse(it -> values.set(name, node(it)), () -> values.put(name, value));
        });
    for (Parameter each : parameters) {
      // A number may be replaced by a factor; a text stays as it usually is.
      number(each.usual())
          .ifPresentOrElse(
              it -> values.set(each.name(), node(it)), () -> values.put(each.name(), each.usual()));
    }
    declared.forEach(
        (name, value) -> {
          if (more.contains(name) && !values.has(name)) {
            number(value).ifPresent(it -> values.set(name, node(it)));
          }
        });
    return written;
  }

  /** Returns a number without a fraction of zeros, which whole types do not take. */
  private static NumericNode node(BigDecimal number) {
    BigDecimal plain = number.stripTrailingZeros();
    return plain.scale() <= 0
        ? BigIntegerNode.valueOf(plain.toBigIntegerExact())
        : DecimalNode.valueOf(plain);
  }

  /** Returns whether a file is read by {@link #read}, by its name. */
  public static boolean isOne(Path file) {
    return ScenarioFiles.isOpenScenario(file);
  }

  private static VariedScenario of(Variations variations) {
    Map<String, Set<String>> values = new LinkedHashMap<>();
    for (Map<String, String> each : variations.cases()) {
      each.forEach(
          (name, value) -> values.computeIfAbsent(name, key -> new TreeSet<>()).add(value));
    }
    Map<String, String> first = variations.cases().get(0);
    Map<String, String> fixed = new LinkedHashMap<>();
    List<Parameter> parameters = new ArrayList<>();
    values.forEach(
        (name, different) -> {
          if (different.size() == 1) {
            fixed.put(name, first.get(name));
          } else {
            List<String> inOrder =
                variations.cases().stream().map(each -> each.get(name)).distinct().toList();
            parameters.add(new Parameter(name, first.get(name), inOrder, false));
          }
        });
    List<List<String>> rows =
        variations.cases().stream()
            .map(each -> parameters.stream().map(it -> each.get(it.name()).strip()).toList())
            .toList();
    return new VariedScenario(
        variations.scenario().path(),
        fixed,
        parameters,
        isGrid(parameters, rows) ? List.of() : rows,
        declared(variations.scenario()));
  }

  private static boolean isGrid(List<Parameter> parameters, List<List<String>> rows) {
    long all = 1;
    for (Parameter each : parameters) {
      all *= each.values().size();
      if (all > rows.size()) {
        return false;
      }
    }
    return all == rows.size() && rows.stream().distinct().count() == all;
  }

  /** Returns a parameter that one group of constraints bounds; none that follows from others. */
  private static Optional<Parameter> bounded(ParameterDeclaration declared) {
    boolean whole = declared.type().equals("int") || declared.type().startsWith("unsigned");
    if (declared.constraints().size() != 1
        || declared.value().contains("$")
        || !(whole || declared.type().equals("double"))) {
      return Optional.empty();
    }
    Bounds bounds = new Bounds(whole);
    declared.constraints().get(0).forEach(bounds::add);
    return bounds
        .values()
        .map(values -> new Parameter(declared.name(), declared.value(), values, !whole));
  }

  private static Optional<BigDecimal> number(String text) {
    try {
      BigDecimal number = new BigDecimal(text.strip());
      boolean usual = Math.abs((double) number.scale()) <= MOST_DIGITS;
      return Optional.of(number).filter(each -> usual && each.precision() <= MOST_DIGITS);
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /** The bounds of a parameter. A limit that is not allowed itself is left by a millionth. */
  private static final class Bounds {

    private static final BigDecimal MILLIONTH = BigDecimal.valueOf(1, 6);

    private final boolean whole;
    private Optional<BigDecimal> least = Optional.empty();
    private Optional<BigDecimal> most = Optional.empty();
    private boolean leastIsOpen;
    private boolean mostIsOpen;

    Bounds(boolean whole) {
      this.whole = whole;
    }

    void add(ParameterDeclaration.Constraint constraint) {
      Optional<BigDecimal> limit = number(constraint.value());
      switch (constraint.rule()) {
        case "greaterThan", "greaterOrEqual" -> {
          if (limit.isPresent() && (least.isEmpty() || limit.get().compareTo(least.get()) >= 0)) {
            least = limit;
            leastIsOpen = constraint.rule().equals("greaterThan");
          }
        }
        case "lessThan", "lessOrEqual" -> {
          if (limit.isPresent() && (most.isEmpty() || limit.get().compareTo(most.get()) <= 0)) {
            most = limit;
            mostIsOpen = constraint.rule().equals("lessThan");
          }
        }
        default -> {} // One value that it is or is not bounds nothing.
      }
    }

    /** Returns the bounds, or all values of a whole type; empty if there are no two of them. */
    Optional<List<String>> values() {
      if (least.isEmpty() || most.isEmpty() || least.get().compareTo(most.get()) >= 0) {
        return Optional.empty();
      }
      BigDecimal span = most.get().subtract(least.get());
      BigDecimal inside = whole ? BigDecimal.ONE : span.multiply(MILLIONTH);
      BigDecimal from = leastIsOpen ? least.get().add(inside) : least.get();
      BigDecimal to = mostIsOpen ? most.get().subtract(inside) : most.get();
      return whole ? wholes(from, to) : Optional.of(List.of(text(from), text(to)));
    }

    private static Optional<List<String>> wholes(BigDecimal from, BigDecimal to) {
      List<String> values = new ArrayList<>();
      for (BigDecimal each = from; each.compareTo(to) <= 0; each = each.add(BigDecimal.ONE)) {
        values.add(text(each));
        if (values.size() > MOST_WHOLE) {
          return Optional.empty();
        }
      }
      return values.size() > 1 ? Optional.of(values) : Optional.empty();
    }

    private static String text(BigDecimal number) {
      return number.signum() == 0 ? "0" : number.stripTrailingZeros().toPlainString();
    }
  }
}
