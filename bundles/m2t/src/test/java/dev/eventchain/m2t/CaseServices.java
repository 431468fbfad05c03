package dev.eventchain.m2t;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.eclipse.emf.ecore.EObject;

/** The Java services of the cases. */
public class CaseServices {
  private int calls;

  public static String greet(String name) {
    return "hello " + name;
  }

  public String describe(EObject object, int times) {
    return (object.eClass().getName() + " ").repeat(times).strip();
  }

  /** Counts, and shows that the instance lives as long as the run. */
  public int count() {
    return ++calls;
  }

  public static double half(double number) {
    return number / 2;
  }

  public static List<String> twice(Collection<String> texts) {
    List<String> all = new ArrayList<>(texts);
    all.addAll(texts);
    return all;
  }

  public static char[] letters(String text) {
    return text.toCharArray();
  }

  public static boolean isNull(Object value) {
    return value == null;
  }

  public static Object nothing() {
    return null;
  }

  public static String fail(String message) {
    throw new IllegalStateException(message);
  }

  public static String overflow() {
    return overflow() + ".";
  }
}
