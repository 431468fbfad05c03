package dev.eventchain.catalogue.arxml;

import dev.eventchain.catalogue.arxml.ArxmlLimits.NoNumberException;
import dev.eventchain.catalogue.network.NetworkSignal;
import dev.eventchain.catalogue.network.SendingCondition;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Reads multiplexed PDUs: a number in each says which of several other PDUs is there. */
final class ArxmlMultiplexers {

  /** Name of a selector that no PDU has as a signal. */
  private static final String SELECTOR = "Selector";

  private static final int LARGEST_START = 1 << 19;
  private static final int LONGEST = 64;

  private final ArxmlTree tree;
  private final ArxmlPdus pdus;

  ArxmlMultiplexers(ArxmlTree tree, ArxmlPdus pdus) {
    this.tree = tree;
    this.pdus = pdus;
  }

  /** Returns the selector, the signals that are always there, and those of the alternatives. */
  List<NetworkSignal> of(ArxmlElement pdu, ArxmlPdus.Place place, ArxmlPdus.Content content)
      throws NoNumberException {
    NetworkSignal.Layout layout = layout(pdu, place.shift());
    ArxmlPdus.Place inner = place.below(ArxmlPdus.cycle(pdu, place));
    List<NetworkSignal> always = always(pdu, inner, content);
    Map<NetworkSignal, List<SendingCondition.Range>> sometimes = new LinkedHashMap<>();
    for (Map.Entry<ArxmlElement, List<SendingCondition.Range>> each :
        alternatives(pdu).entrySet()) {
      content.parts().add(each.getKey());
      pdus.signals(each.getKey(), inner, content)
          .forEach(signal -> sometimes.put(signal, each.getValue()));
    }
    NetworkSignal selector = selector(pdu, layout, always, sometimes);
    List<NetworkSignal> all = new ArrayList<>(List.of(selector));
    always.stream().filter(it -> !isAt(layout, it)).forEach(all::add);
    sometimes.forEach(
        (signal, numbers) -> {
          if (!isAt(layout, signal)) {
            signal.condition(new SendingCondition(selector, numbers));
            all.add(signal);
          }
        });
    return all;
  }

  private List<NetworkSignal> always(
      ArxmlElement pdu, ArxmlPdus.Place inner, ArxmlPdus.Content content) throws NoNumberException {
    List<NetworkSignal> always = new ArrayList<>();
    for (ArxmlElement part : pdu.all("STATIC-PARTS", "STATIC-PART")) {
      Optional<ArxmlElement> other = plain(part);
      if (other.isPresent()) {
        content.parts().add(other.get());
        always.addAll(pdus.signals(other.get(), inner, content));
      }
    }
    return always;
  }

  private static NetworkSignal.Layout layout(ArxmlElement pdu, int shift) throws NoNumberException {
    return new NetworkSignal.Layout(
        shift + (int) number(pdu, "SELECTOR-FIELD-START-POSITION", LARGEST_START),
        (int) Math.max(1, number(pdu, "SELECTOR-FIELD-LENGTH", LONGEST)),
        pdu.text("SELECTOR-FIELD-BYTE-ORDER").filter(ArxmlSignals.BIG_ENDIAN::equals).isPresent(),
        false,
        BigDecimal.ONE,
        BigDecimal.ZERO,
        Optional.empty(),
        Optional.empty());
  }

  private static long number(ArxmlElement element, String tag, long largest)
      throws NoNumberException {
    Optional<ArxmlElement> number = element.first(tag);
    if (number.isEmpty()) {
      throw new NoNumberException(
          "'" + element.path() + "' has no " + tag + ".", element.location());
    }
    return ArxmlLimits.whole(number.get(), largest);
  }

  private static boolean isAt(NetworkSignal.Layout selector, NetworkSignal signal) {
    return signal.layout().start() == selector.start()
        && signal.layout().length() == selector.length();
  }

  /** Returns the numbers with which each alternative is there. */
  private Map<ArxmlElement, List<SendingCondition.Range>> alternatives(ArxmlElement pdu)
      throws NoNumberException {
    Map<ArxmlElement, List<SendingCondition.Range>> alternatives = new LinkedHashMap<>();
    for (ArxmlElement each :
        pdu.all(
            "DYNAMIC-PARTS",
            "DYNAMIC-PART",
            "DYNAMIC-PART-ALTERNATIVES",
            "DYNAMIC-PART-ALTERNATIVE")) {
      long code = number(each, "SELECTOR-FIELD-CODE", Integer.MAX_VALUE);
      plain(each)
          .ifPresent(
              other ->
                  alternatives
                      .computeIfAbsent(other, key -> new ArrayList<>())
                      .add(SendingCondition.Range.of(BigDecimal.valueOf(code))));
    }
    return alternatives;
  }

  private Optional<ArxmlElement> plain(ArxmlElement part) {
    return tree.follow(part, Set.of("I-SIGNAL-I-PDU"), "I-PDU-REF");
  }

  /** Returns the selector with the name of the first signal at its place, and texts of all. */
  private static NetworkSignal selector(
      ArxmlElement pdu,
      NetworkSignal.Layout layout,
      List<NetworkSignal> always,
      Map<NetworkSignal, List<SendingCondition.Range>> sometimes) {
    List<NetworkSignal> at = new ArrayList<>(always);
    at.addAll(sometimes.keySet());
    at.removeIf(it -> !isAt(layout, it));
    String name = at.isEmpty() ? SELECTOR : at.get(0).name();
    NetworkSignal selector =
        new NetworkSignal(name, "M", layout, "", at.isEmpty() ? pdu.location() : at.get(0).place());
    for (NetworkSignal each : at) {
      each.texts().forEach(selector.texts()::putIfAbsent);
      if (selector.comment().isEmpty()) {
        selector.comment(each.comment());
      }
      each.cycle().ifPresent(ms -> selector.cycle(Math.min(ms, selector.cycle().orElse(ms))));
    }
    return selector;
  }
}
