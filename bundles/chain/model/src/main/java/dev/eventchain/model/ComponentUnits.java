package dev.eventchain.model;

import dev.eventchain.model.eventchain.Data;

/** Units in which components have their values, which may differ from those of the messages. */
public final class ComponentUnits {

  private ComponentUnits() {}

  /** Returns the unit in which the component has the value; empty if none is known. */
  public static String of(Data data) {
    String own = stated(data.getComponentUnit());
    return own.isEmpty() ? onTheWire(data) : own;
  }

  /** Returns the unit of the value in messages; empty if none is stated. */
  public static String onTheWire(Data data) {
    return stated(data.getUnit());
  }

  /** Returns whether the generated node has to convert the value. */
  public static boolean isConverted(Data data) {
    return !of(data).equals(onTheWire(data));
  }

  private static String stated(String unit) {
    return unit == null ? "" : unit.strip();
  }
}
