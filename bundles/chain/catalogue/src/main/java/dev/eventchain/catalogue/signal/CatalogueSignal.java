package dev.eventchain.catalogue.signal;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.Signal.NamedNumber;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A signal of a catalogue.
 *
 * @param path its name with those of the groups that it is in: "Vehicle.Cabin.IsLit"
 * @param role what software does with it
 * @param type its type as message definitions write it: "float32", "uint8[]"; empty if no message
 *     definition has such a type
 * @param unit its unit; empty without one
 * @param least the least value that it may have
 * @param most the greatest value that it may have
 * @param allowed the only values that it may have, as texts; empty if all
 * @param names the names of numbers, in the unit of the signal
 * @param description what it means; may be empty
 * @param groups what the groups that it is in mean, outermost first, as far as they say so
 * @param location the location of its description
 */
public record CatalogueSignal(
    String path,
    Role role,
    Optional<String> type,
    String unit,
    OptionalDouble least,
    OptionalDouble most,
    List<String> allowed,
    List<NamedNumber> names,
    String description,
    List<String> groups,
    SourceLocation location) {

  /** Direction of a signal, as software uses it. */
  public enum Role {
    /** A measured value, which software reads. */
    SENSOR,
    /** A value that software reads and sets. */
    ACTUATOR,
    /** A property of the vehicle, which does not change while it drives. */
    ATTRIBUTE,
    /** A value that software sends, and that nobody else does. */
    COMMAND
  }

  /** Copies the lists. */
  public CatalogueSignal {
    allowed = List.copyOf(allowed);
    names = List.copyOf(names);
    groups = List.copyOf(groups);
  }

  /** Returns the meaning with range and allowed values, in one line. */
  public String meaning() {
    StringBuilder text = new StringBuilder(description.replaceAll("\\s+", " ").strip());
    if (least.isPresent() || most.isPresent()) {
      text.append(text.isEmpty() ? "" : " ").append("Range: ").append(range()).append('.');
    }
    if (!allowed.isEmpty()) {
      text.append(text.isEmpty() ? "" : " ").append("One of: ").append(String.join(", ", allowed));
      text.append('.');
    }
    return text.toString();
  }

  private String range() {
    if (least.isEmpty()) {
      return "at most " + plain(most.getAsDouble());
    }
    String from = plain(least.getAsDouble());
    return most.isEmpty() ? from + " or more" : from + " to " + plain(most.getAsDouble());
  }

  private static String plain(double number) {
    return number == Math.rint(number) && Math.abs(number) < 1e15
        ? String.valueOf((long) number)
        : String.valueOf(number);
  }
}
