package dev.eventchain.contracts;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.EventChain;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * What OCL cannot say about a chain: whether its components, and the vehicle around it, agree on
 * the meaning of each topic, which otherwise fails on the road and silently; and what follows from
 * the flow of the whole chain.
 *
 * <p>What a single element looks like is left to the standard constraints: data without a topic, a
 * legal type or a field are not looked at here.
 */
public final class ChainAnalysis {

  private final MessageCatalog catalog;
  private final Optional<Map<String, Signal>> signals;

  private ChainAnalysis(MessageCatalog catalog, Optional<Map<String, Signal>> signals) {
    this.catalog = catalog;
    this.signals = signals;
  }

  /**
   * An analysis of chains for one vehicle.
   *
   * @param catalog the message types that there are
   * @param signals the topics outside the chain; empty if they are not known, so that who writes
   *     and reads at the ends of the chain cannot be checked
   */
  public static ChainAnalysis of(MessageCatalog catalog, Optional<List<Signal>> signals) {
    return new ChainAnalysis(catalog, signals.map(ChainAnalysis::byTopic));
  }

  private static Map<String, Signal> byTopic(List<Signal> signals) {
    Map<String, Signal> byTopic = new LinkedHashMap<>();
    signals.forEach(signal -> byTopic.putIfAbsent(RosNames.resolve(signal.topic(), ""), signal));
    return byTopic;
  }

  /**
   * Checks a chain, and the definitions in the user's folders of messages.
   *
   * @param locator the places of the features of the chain's elements
   */
  public AnalysisResult check(
      EventChain chain, BiFunction<EObject, EStructuralFeature, SourceLocation> locator) {
    Findings findings = new Findings(locator);
    findings.addAll(catalog.diagnostics());
    List<Topic> topics = Topic.of(chain, signals.orElse(Map.of()));
    TypeContracts types = new TypeContracts(catalog, findings);
    DataFlowIndex flow = DataFlowIndex.of(chain);
    TopicContracts partners = new TopicContracts(topics, signals, flow, types, findings);
    SignalContracts described = new SignalContracts(types, findings);
    UnitContracts units = new UnitContracts(findings);
    AgeContracts ages = new AgeContracts(types, findings);
    QosContracts qos = new QosContracts(findings);
    for (Topic topic : topics) {
      types.check(topic);
      partners.check(topic);
      described.check(topic);
      units.check(topic);
      ages.check(topic);
      qos.check(topic);
    }
    new FlowRules(chain, flow, findings).check();
    return findings.result();
  }
}
