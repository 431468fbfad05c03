package dev.eventchain.m2t;

import java.net.URI;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Java services of the test cases. */
public class CaseServices {
  private int calls;

  public static String greet(String name) {
    return "hello " + name;
  }

  public String describe(EObject object, int times) {
    return (object.eClass().getName() + " ").repeat(times).strip();
  }

  /** Returns a counter, which shows that the instance lives as long as the run. */
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

  @SuppressWarnings("InfiniteRecursion") // what a service may get wrong
  public static String overflow() {
    return overflow() + ".";
  }

  public static String join(List<String> some, Set<List<String>> others) {
    return String.join("+", some) + others.size();
  }

  public static long length(String text) {
    return text.length();
  }

  public static long lengthOfManyBooks(String text) {
    return text.length() * 1_000_000_000_000L;
  }

  public static List<Object> mixed() {
    return Arrays.asList("a", null, 1);
  }

  public static List<Long> sizes() {
    return List.of(1L, 2L);
  }

  /** Returns objects with a text, and empty and non-empty Optionals. */
  public static List<Object> objects() {
    return List.of(URI.create("built"), Optional.of("held"), Optional.empty(), new int[] {1, 2});
  }

  /** Adds a copy of an object next to it, in its file. */
  public static String grow(EObject object) {
    object.eResource().getContents().add(EcoreUtil.copy(object));
    return "grown";
  }

  public static Object iterator() {
    return List.of("a").iterator();
  }

  public static Object nullAsText() {
    return new Object() {
      @SuppressWarnings("ToStringReturnsNull") // what a service may get wrong
      @Override
      public String toString() {
        return null;
      }
    };
  }

  public static Object[] failingText() {
    Object failing =
        new Object() {
          @Override
          public String toString() {
            throw new IllegalStateException("no text today");
          }
        };
    return new Object[] {failing};
  }

  public static boolean secondIsNull(EObject first, Object second) {
    return second == null;
  }
}
