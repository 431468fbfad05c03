package dev.eventchain.contracts.latency;

import dev.eventchain.contracts.timing.ResponseTimes;
import dev.eventchain.contracts.timing.ResponseTimes.Demand;
import dev.eventchain.contracts.timing.ResponseTimes.Response;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.Processor;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;

/**
 * Processors of a chain, with the components that are mapped to them. Each component is one
 * periodic task: the callback of its timer executes it, and the callbacks of its subscriptions only
 * keep messages. The operating system, the middleware, and what else runs on a processor take no
 * time.
 */
public final class Deployment {

  /**
   * Load of a processor.
   *
   * @param shares of the components, in chain order; at least one
   * @param ordered whether each of them has a priority, so that it is known which goes first
   */
  public record Load(Processor processor, List<Share> shares, boolean ordered) {

    /** Copies the list. */
    public Load {
      shares = List.copyOf(shares);
    }

    /** Returns the sum of the parts that are known, exactly; 1 is all of the processor's time. */
    public BigDecimal known() {
      return shares.stream()
          .flatMap(share -> share.utilisation().stream())
          .reduce(BigDecimal.ZERO, BigDecimal::add);
    }

    /** Returns the utilisation; empty if that of a component is not known. */
    public Optional<BigDecimal> utilisation() {
      boolean all = shares.stream().allMatch(share -> share.utilisation().isPresent());
      return all ? Optional.of(known()) : Optional.empty();
    }

    /** Returns whether the components need more time than there is, whatever is not known. */
    public boolean isOverloaded() {
      return known().compareTo(BigDecimal.ONE) > 0;
    }

    /** Returns the other components that may go before one, so that it waits for them. */
    public List<SoftwareNode> before(SoftwareNode node) {
      return shares.stream()
          .map(Share::node)
          .filter(other -> other != node)
          .filter(other -> !ordered || other.getPriority() >= node.getPriority())
          .toList();
    }
  }

  /**
   * Share of a component in its processor.
   *
   * @param utilisation the part of the time that it takes at most; empty if unknown
   */
  public record Share(SoftwareNode node, Optional<BigDecimal> utilisation, Response response) {

    /** Returns what is missing for the utilisation, in words; empty if nothing is. */
    public Optional<String> unknown() {
      String name = "'" + node.getName() + "'";
      if (utilisation.isPresent()) {
        return Optional.empty();
      } else if (!NodeTimes.isComponent(node)) {
        return Optional.of(
            name + " is a node of its own, and the model does not say what activates it");
      }
      return Optional.of(
          NodeTimes.execution(node).isEmpty()
              ? name + " states no worst-case execution time"
              : name + " states no frequency");
    }
  }

  private final List<Load> loads = new ArrayList<>();

  private Deployment() {}

  /** Returns the deployment of a chain; later changes of the chain are not seen. */
  public static Deployment of(EventChain chain) {
    Map<Processor, List<SoftwareNode>> mapped = new LinkedHashMap<>();
    chain.getProcessors().forEach(processor -> mapped.put(processor, new ArrayList<>()));
    for (SoftwareNode node : chain.getSoftware()) {
      if (node.getMappedTo() != null) {
        mapped.computeIfAbsent(node.getMappedTo(), none -> new ArrayList<>()).add(node);
      }
    }
    Deployment deployment = new Deployment();
    mapped.forEach(
        (processor, nodes) -> {
          if (!nodes.isEmpty()) {
            deployment.loads.add(load(processor, nodes));
          }
        });
    return deployment;
  }

  private static Load load(Processor processor, List<SoftwareNode> nodes) {
    List<Demand> demands = nodes.stream().map(Deployment::demand).toList();
    List<Response> responses = ResponseTimes.of(demands);
    List<Share> shares = new ArrayList<>();
    for (int i = 0; i < nodes.size(); i++) {
      SoftwareNode node = nodes.get(i);
      shares.add(new Share(node, NodeTimes.utilisation(node), responses.get(i)));
    }
    return new Load(processor, shares, ResponseTimes.ordered(demands));
  }

  private static Demand demand(SoftwareNode node) {
    return new Demand(
        NodeTimes.shortestPeriod(node),
        NodeTimes.execution(node),
        node.isSetPriority() ? OptionalInt.of(node.getPriority()) : OptionalInt.empty());
  }

  /** Returns the processors with components, in the chain's order. */
  public List<Load> loads() {
    return List.copyOf(loads);
  }

  /**
   * Returns the load of the processor that a component shares with others; empty if it does not.
   */
  Optional<Load> shared(SoftwareNode node) {
    return loads.stream()
        .filter(load -> load.processor() == node.getMappedTo() && load.shares().size() > 1)
        .findFirst();
  }

  /** Returns the share of a component in a processor that others use, too. */
  Optional<Deployment.Share> share(SoftwareNode node) {
    return shared(node)
        .flatMap(load -> load.shares().stream().filter(it -> it.node() == node).findFirst());
  }

  /** Returns the worst-case response time; empty if it is unknown or may exceed the period. */
  OptionalLong response(SoftwareNode node) {
    Optional<Deployment.Share> share = share(node);
    if (share.isPresent()) {
      return share.get().response().bound();
    }
    return NodeTimes.isOverloaded(node) ? OptionalLong.empty() : NodeTimes.execution(node);
  }
}
