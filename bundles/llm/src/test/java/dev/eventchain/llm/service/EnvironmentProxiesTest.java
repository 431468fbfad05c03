package dev.eventchain.llm.service;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests which proxy is asked for an address. */
class EnvironmentProxiesTest {

  @ParameterizedTest(name = "{index}: {0} {1}")
  @CsvSource(
      delimiter = '|',
      nullValues = "-",
      value = {
        "HTTPS_PROXY=http://p.example:3128|https://a.example/v1|p.example:3128",
        "https_proxy=p.example:3128|https://a.example/v1|p.example:3128",
        "HTTP_PROXY=http://p.example:3128|https://a.example/v1|-",
        "HTTP_PROXY=http://p.example|http://a.example/v1|p.example:80",
        "HTTP_PROXY=http://p.example NO_PROXY=b.example,.a.example|http://x.a.example/v1|-",
        "HTTP_PROXY=http://p.example NO_PROXY=*|http://a.example/v1|-",
        "HTTP_PROXY=http://p.example NO_PROXY=example|http://notexample/v1|p.example:80",
        "HTTP_PROXY=http://p.example|http://localhost:11434|-",
        "HTTP_PROXY=http://|http://a.example/v1|-",
        "HTTP_PROXY=|http://a.example/v1|-",
      })
  void proxyOfTheEnvironment(String variables, String address, String proxy) {
    Map<String, String> environment = new HashMap<>();
    for (String each : variables.split(" ", -1)) {
      environment.put(each.split("=", 2)[0], each.split("=", 2)[1]);
    }
    InetSocketAddress found =
        (InetSocketAddress)
            new EnvironmentProxies(environment).select(URI.create(address)).get(0).address();
    assertEquals(proxy, found == null ? null : found.getHostString() + ":" + found.getPort());
  }

  @Test
  void aCallGoesThroughTheProxy() throws IOException, InterruptedException {
    HttpServer proxy =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    proxy.createContext(
        "/",
        exchange -> {
          byte[] asked = exchange.getRequestURI().toString().getBytes(StandardCharsets.UTF_8);
          exchange.sendResponseHeaders(200, asked.length);
          exchange.getResponseBody().write(asked);
          exchange.close();
        });
    proxy.start();
    try {
      String address = "127.0.0.1:" + proxy.getAddress().getPort();
      HttpClient client =
          HttpClient.newBuilder()
              .proxy(new EnvironmentProxies(Map.of("HTTP_PROXY", address)))
              .build();
      URI far = URI.create("http://models.example/v1");
      assertEquals(
          "http://models.example/v1",
          client.send(HttpRequest.newBuilder(far).build(), BodyHandlers.ofString()).body());
    } finally {
      proxy.stop(0);
    }
  }
}
