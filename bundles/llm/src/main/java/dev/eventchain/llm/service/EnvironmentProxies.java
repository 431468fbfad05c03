package dev.eventchain.llm.service;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Proxy;
import java.net.ProxySelector;
import java.net.SocketAddress;
import java.net.URI;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The proxies that the environment names, as other programs read it: {@code HTTPS_PROXY}, {@code
 * HTTP_PROXY}, and the hosts in {@code NO_PROXY} that are asked without one, in either case. This
 * machine is always asked without one.
 */
final class EnvironmentProxies extends ProxySelector {

  private static final List<String> HERE = List.of("localhost", "127.0.0.1", "[::1]");
  private static final int USUAL_PORT = 80;

  private final Map<String, String> environment;

  EnvironmentProxies(Map<String, String> environment) {
    this.environment = environment;
  }

  @Override
  public List<Proxy> select(URI address) {
    String host = String.valueOf(address.getHost()).toLowerCase(Locale.ROOT);
    if (HERE.contains(host) || isExcepted(host)) {
      return List.of(Proxy.NO_PROXY);
    }
    String variable = "https".equals(address.getScheme()) ? "HTTPS_PROXY" : "HTTP_PROXY";
    return List.of(value(variable).flatMap(EnvironmentProxies::proxy).orElse(Proxy.NO_PROXY));
  }

  private boolean isExcepted(String host) {
    return value("NO_PROXY").stream()
        .flatMap(list -> Stream.of(list.split("[,\\s]+")))
        .map(each -> each.toLowerCase(Locale.ROOT).replaceFirst("^\\*?\\.", ""))
        .filter(each -> !each.isEmpty())
        .anyMatch(each -> each.equals("*") || host.equals(each) || host.endsWith("." + each));
  }

  private Optional<String> value(String variable) {
    return Stream.of(variable, variable.toLowerCase(Locale.ROOT))
        .map(environment::get)
        .filter(value -> value != null && !value.isBlank())
        .map(String::strip)
        .findFirst();
  }

  /** Returns a proxy by its address, with or without a scheme; empty if it is none. */
  private static Optional<Proxy> proxy(String address) {
    try {
      URI uri = URI.create(address.contains("://") ? address : "http://" + address);
      int port = uri.getPort() < 0 ? USUAL_PORT : uri.getPort();
      return Optional.ofNullable(uri.getHost())
          .map(host -> new Proxy(Proxy.Type.HTTP, InetSocketAddress.createUnresolved(host, port)));
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // Without a usable proxy, the failed call says what is wrong.
    }
  }

  @Override
  public void connectFailed(URI address, SocketAddress proxy, IOException cause) {
    // The call reports it.
  }
}
