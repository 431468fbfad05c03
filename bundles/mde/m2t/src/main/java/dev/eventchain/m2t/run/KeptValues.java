package dev.eventchain.m2t.run;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.impl.BasicEObjectImpl;

/**
 * Cache of the values of queries in a run. Most queries have a model element as only argument, and
 * many are called for the same element in succession. The values are therefore stored by element,
 * which has better memory locality than a table for each query.
 */
public final class KeptValues {

  /** Indices of queries in the value tables of the instances of a class. */
  private static final class Places {
    /** Index plus one by the number of the query; 0 if there is none. */
    private int[] places = {};

    private int count;

    int of(int number) {
      return number < places.length ? places[number] - 1 : -1;
    }

    int add(int number) {
      if (number >= places.length) {
        places = Arrays.copyOf(places, number + 1);
      }
      places[number] = ++count;
      return count - 1;
    }
  }

  /** Values kept for an element. */
  private static final class OfElement {
    private final BasicEObjectImpl element;
    private final Places places;
    private Object[] values = {};

    OfElement(BasicEObjectImpl element, Places places) {
      this.element = element;
      this.places = places;
    }

    Object get(int query) {
      int place = places.of(query);
      return place >= 0 && place < values.length ? values[place] : null;
    }

    void put(int query, Object value) {
      int known = places.of(query);
      int place = known < 0 ? places.add(query) : known;
      if (place >= values.length) {
        values = Arrays.copyOf(values, Math.max(places.count, place + 1));
      }
      values[place] = value;
    }
  }

  /** A call with other arguments than one element, and its value. */
  private record OfCall(int query, Object call, Object value) {
    boolean is(int otherQuery, Object otherCall) {
      return query == otherQuery && Objects.equals(call, otherCall);
    }
  }

  /** Number of recent elements, enough for an element and its neighbourhood. */
  private static final int RECENT = 256;

  private static final int RECENT_CALLS = 1024;

  private final Map<BasicEObjectImpl, OfElement> ofElements = new HashMap<>();
  private final Map<EClass, Places> places = new HashMap<>();

  /** Recently used elements, indexed by hash. */
  private final OfElement[] recent = new OfElement[RECENT];

  /** Values of calls with other arguments than one element, by the number of the query. */
  private final List<Map<Object, Object>> others = new ArrayList<>();

  /** Recently used calls of that kind, indexed by hash. */
  private final OfCall[] recentCalls = new OfCall[RECENT_CALLS];

  /**
   * Returns the cached value of a call of a query; null if there is none.
   *
   * @param query the number of the query
   * @param call the only argument, or the list of all arguments
   */
  public Object get(int query, Object call) {
    if (call instanceof BasicEObjectImpl element) {
      OfElement kept = of(element);
      return kept == null ? null : kept.get(query);
    }
    int place = placeOf(query, call);
    OfCall latest = recentCalls[place];
    if (latest != null && latest.is(query, call)) {
      return latest.value();
    }
    Object value = query < others.size() ? others.get(query).get(call) : null;
    if (value != null) {
      recentCalls[place] = new OfCall(query, call, value);
    }
    return value;
  }

  private static int placeOf(int query, Object call) {
    int hash = call == null ? 0 : call.hashCode();
    return (hash ^ (hash >>> 16) ^ query * 31) & (RECENT_CALLS - 1);
  }

  /** Caches the value of a call, which must not be null. */
  public void put(int query, Object call, Object value) {
    if (call instanceof BasicEObjectImpl element) {
      OfElement kept = of(element);
      if (kept == null) {
        Places ofClass = places.computeIfAbsent(element.eClass(), any -> new Places());
        kept = new OfElement(element, ofClass);
        ofElements.put(element, kept);
        recent[element.hashCode() & (RECENT - 1)] = kept;
      }
      kept.put(query, value);
    } else {
      while (others.size() <= query) {
        others.add(new HashMap<>());
      }
      others.get(query).put(call, value);
      recentCalls[placeOf(query, call)] = new OfCall(query, call, value);
    }
  }

  private OfElement of(BasicEObjectImpl element) {
    int place = element.hashCode() & (RECENT - 1);
    OfElement latest = recent[place];
    if (latest != null && latest.element == element) {
      return latest;
    }
    OfElement kept = ofElements.get(element);
    if (kept != null) {
      recent[place] = kept;
    }
    return kept;
  }
}
