// SPDX-License-Identifier: MIT
// Data of Basis Universal (encoder and decoder of the PyPI package alktx2 0.1.7), from pictures and bits that were made
// for this test.
#include "tests/importer/ktx2_samples.h"

#include <algorithm>
#include <string_view>

#include "importer/file/base64.h"

namespace sinew::test {
namespace {

std::vector<std::byte> from_base64(std::string_view base64) { return decode_base64(base64).value(); }

std::vector<std::uint8_t> texels_of(std::string_view base64) {
  const auto bytes = from_base64(base64);
  std::vector<std::uint8_t> out(bytes.size());
  std::transform(bytes.begin(), bytes.end(), out.begin(), [](std::byte b) { return std::to_integer<std::uint8_t>(b); });
  return out;
}

template <class Number>
void append(std::vector<std::byte>& out, Number value) {
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    out.push_back(static_cast<std::byte>(static_cast<std::uint64_t>(value) >> 8 * i));
}

}  // namespace

const Ktx2Sample& etc1s_sample() {
  static const Ktx2Sample sample{
      13, 7,
      from_base64("q0tUWCAyMLsNChoKAAAAAAEAAAANAAAABwAAAAAAAAAAAAAAAQAAAAQAAAABAAAAsAAAACwAAADc"
                  "AAAAJAAAAAABAAAAAAAABgEAAAAAAAAKAg"
                  "AAAAAAAAYAAAAAAAAAAAAAAAAAAAAIAgAAAAAAAAIAAAAAAAAAAAAAAAAAAAAHAgAAAAAAAAEAAA"
                  "AAAAAAAAAAAAAAAAAGAgAAAAAAAAEAAAAA"
                  "AAAAAAAAAAAAAAAsAAAAAAAAAAIAKACjAQIAAwMAAAgAAAAAAAAAAAA/AAAAAAAAAAAA/////"
                  "x8AAABLVFh3cml0ZXIAQmFzaXMgVW5pdmVyc2"
                  "FsIDIuMTAAAAwADABEAAAAMQAAAC0AAAAAAAAAAAAAAAAAAAAGAAAAAAAAAAAAAAAAAAAAAAAAAA"
                  "IAAAAAAAAAAAAAAAAAAAAAAAAAAQAAAAAA"
                  "AAAAAAAAAAAAAAAAAAABAAAAAAAAAAAAAAAgQNSAAQAAQJA2Z+IDQIAnAAMACMJ+"
                  "fNFgYaOcAQgQA2AAAAAYZO10TBMAJgAAAAAAABBMl7MuBW"
                  "KLRd4BAm/7nPaQBKyqqqqCoizNB6Is1QeCJCenJCUnhyJNT68sTc+nLM/Pz8/"
                  "PzwdI9fcHqFL9B6hSVQUAwUQAAAAAAADyX40BmAIwAAAABMC8"
                  "GQ3AA6QBAABhI8AlAJgAAAAAAABAAAFu9loAsoJE7QwB"),
      texels_of("E1Us/xNVLP8TVSz/HV82/1pSKP9aUij/Zl40/2ZeNP+kWiD/pFog/6RaIP+wZiz/1log/"
                "xNVLP8TVSz/HV82/x1fNv9aUij/Zl40/2ZeNP9waD"
                "7/pFog/7BmLP+wZiz/unA2/+JmLP8TVSz/HV82/x1fNv8pa0L/Zl40/2ZeNP9waD7/cGg+/"
                "7BmLP+wZiz/unA2/7pwNv/scDb/E1Us/x1fNv8p"
                "a0L/KWtC/2ZeNP9waD7/fHRK/3x0Sv+6cDb/unA2/8Z8Qv/GfEL/+HxC/xBSpP8cXrD/HF6w/"
                "yZouv9SYpz/Xm6o/15uqP9oeLL/pHuc/6R7nP"
                "+wh6j/sIeo/9aLnP8QUqT/HF6w/yZouv8maLr/Xm6o/15uqP9oeLL/dIS+/6R7nP+wh6j/upGy/"
                "7qRsv/il6j/EFKk/xxesP8maLr/MnTG/15u"
                "qP9oeLL/dIS+/3SEvv+wh6j/upGy/7qRsv/Gnb7/7KGy/w==")};
  return sample;
}

const Ktx2Sample& etc1s_alpha_sample() {
  static const Ktx2Sample sample{
      13, 7,
      from_base64("q0tUWCAyMLsNChoKAAAAAAEAAAANAAAABwAAAAAAAAAAAAAAAQAAAAEAAAABAAAAaAAAADwAAACk"
                  "AAAAJAAAAMgAAAAAAAAA0gAAAAAAAACaAQ"
                  "AAAAAAAAsAAAAAAAAAAAAAAAAAAAA8AAAAAAAAAAIAOACjAQIAAwMAAAgIAAAAAAAAAAA/"
                  "AAAAAAAAAAAA/////0AAPw8AAAAAAAAAAP////8f"
                  "AAAAS1RYd3JpdGVyAEJhc2lzIFVuaXZlcnNhbCAyLjEwAAAJABAAPQAAAEEAAAAsAAAAAAAAAAAA"
                  "AAAAAAAABgAAAAYAAAAFAAAAIEDUgAEAAE"
                  "CQNmfiA0CAJwACAACC1FbdoCMhCBA1YAAAAADSzAG6AmACgAAAAAAEWtH6nNUUCINpU4Bwb/"
                  "x5GB7+//8HgOf/eQD4//8HqFL9B6hSVQWiLNWH"
                  "oizNhyJNT68sTc+nLM/PpyQlJx+G5+cfhuf/"
                  "eRiG538YhocHAMFEAAAAAAAQtMP+rCUAUwAAAAAAIJCeCKABiAAAgBoiAJgAAAAAAABAAAEKhm"
                  "IlOQGP00LfEw=="),
      texels_of("E1UsNBNVLDQTVSzUHV821FpSKNRaUig0Zl40NGZeNNSkWiDUpFog1KRaIDSwZiw01log1BNVLDQ"
                "TVSzUHV821B1fNtRaUig0Zl40NGZeNNRwaD"
                "7UpFog1LBmLDSwZiw0unA21OJmLNQTVSzUHV821B1fNtQpa0I0Zl40NGZeNNRwaD7UcGg+"
                "1LBmLDSwZiw0unA21LpwNtTscDbUE1Us1B1fNtQp"
                "a0I0KWtCNGZeNNRwaD7UfHRK1Hx0SjS6cDY0unA21MZ8QtTGfELU+"
                "HxCNBBSpNQcXrA0HF6wNCZoutRSYpzUXm6o1F5uqDRoeLI0pHuc1KR7nN"
                "Swh6jUsIeoNNaLnDQQUqQ0HF6wNCZoutQmaLrUXm6o1F5uqDRoeLI0dIS+"
                "1KR7nNSwh6jUupGyNLqRsjTil6jUEFKkNBxesNQmaLrUMnTG1F5u"
                "qDRoeLI0dIS+1HSEvtSwh6jUupGyNLqRsjTGnb7U7KGy1A==")};
  return sample;
}

const Ktx2Sample& uastc_zstd_sample() {
  static const Ktx2Sample sample{
      13, 7,
      from_base64(
          "q0tUWCAyMLsNChoKAAAAAAEAAAANAAAABwAAAAAAAAAAAAAAAQAAAAEAAAACAAAAaAAAACwAAACUAAAAJAAAAAAAAAAAAAAAAAAAAAA"
          "AAAC4AA"
          "AAAAAAAIkAAAAAAAAAgAAAAAAAAAAsAAAAAAAAAAIAKACmAQIAAwMAABAAAAAAAAAAAAB/AwAAAAAAAAAA/////"
          "x8AAABLVFh3cml0ZXIAQmFz"
          "aXMgVW5pdmVyc2FsIDIuMTAAACi1L/0ggAEEAAiQE4qJqAJTATN0d7uL/8wMkJuJMSsDF8EM3REuIjPzDJC7hmWqAxcBzNEd7iI/"
          "MwyRG4rNqA"
          "MXAQARESIi//8IQBV9EbD+FTEDu4jPzM/Mj5CG2uoOmaXt7jJb8Dx4eDhBdXVt/v8VATCIu/zP/M8MkTvdzfz+UQEA7u7/////"),
      texels_of("G1wAJhtcACYbXADZG1wA2WdcANlnXAAmZ1wAJmdcANmzXADZs1wA2bNcACazXAAm5FwA2RtcHyYbXB/"
                "ZG1wf2RtcH9lnYR8mZ2EfJmdhH9lnYR"
                "/Zs2Uf2bNlHyazZR8ms2Uf2eRmH9kbXEHZG1xB2RtcQdkbXEEmZ2dBJmdnQdlnZ0HZZ2dB2bNuQSazbkEms25B2bNuQdnkcUHZG1xh"
                "2RtcYdkb"
                "XGEmG1xhJmdsYdlnbGHZZ2xh2WdsYSazd2Ems3dh2bN3Ydmzd2HZ5HxhJiZng98LXIMmC1yDJiZng99md5ndZneZ3Xd3mSJ3d5kiro"
                "iD366Ig9"
                "+uiIPfvo6DJuSIgyYLXK8mC1yvJiZnr98mZ6/fZneZ3Xd3mSJ3d5kiZneZ3a6Ir9+uiK/fvo6vJr6Orybkmq/"
                "ZC1zEJiZnxN8mZ8TfJmfE31V3"
                "zCJVd8wid4jM3XeIzN2uiMTfvo7EJr6OxCauiMTf5KPE2Q==")};
  return sample;
}

std::span<const UastcSample> uastc_samples() {
  static const std::vector<UastcSample> samples{
      {0, from_base64("gUrl8alBBqCVaiavvM2v5Q=="),
       texels_of("2jsN/7QpQP+vJkf/xTEp/8UxKf/aOw3/lRpq/68mR/+kIVb/qiRO/58eXf+kIVb/lRpq/68mR//KMyL/mhxj/w==")},
      {1, from_base64("dfkKlF9Wk8ZCJ2rVqy2nOQ=="),
       texels_of("oLI0/76qKv/8mhb/vqoq/96iH/+gsjT/3qIf/96iH//eoh//vqoq/76qKv++qir/vqoq//yaFv/8mhb/3qIf/w==")},
      {2, from_base64("XVE3Dpmy10w0J/pI1zKh3w=="),
       texels_of("fpO2/4F9wf93zJn/r1yo/4hE3f9+k7b/ij6g/4o+oP+GV9T/g2rK/3Irm/+jU6X/hlfU/4o+oP+7Zqr/o1Ol/w==")},
      {3, from_base64("Y6yh6SYRWQHdBvJ/jwY80g=="),
       texels_of("dB5F/3QudP8Pyov/AFyL/3QmXf90LnT/ZJJs/0Vci/90Jl3/dCZd/2SSbP9FXIv/dBcu/3QXLv8AXIv/AFyL/w==")},
      {4, from_base64("UxmmIfm9DMwhOXwex5XKdw=="),
       texels_of("S6+6/3tB8v9Lr7r/NOWe/x/dJP9Ulzr/Bv8a/zq5L/9Ulzr/Orkv/zq5L/8G/xr/S6+6/0uvuv9Lr7r/ZHfX/w==")},
      {5, from_base64("S9wD0XqIk02FUnNXouZGRw=="),
       texels_of("EIfZ/zxxtP8mfMf/gU55/5dDZ/9rWYz/Umah/604VP88cbT/JnzH/yZ8x/88cbT/gU55/yZ8x/+tOFT/l0Nn/w==")},
      {6, from_base64("+z4vuB8iP0GSxY79UYXwcQ=="),
       texels_of("/nT//+iahP/omsP//nRI/9DCSP/+dIT/6JpI/7nnSP/omv//6JrD/+iaw//+dIT//nT//7nnSP/omv//uefD/w==")},
      {7, from_base64("B/dneh8TKoGNiCGVoQCyjQ=="),
       texels_of("+Q1o//crSP/3K0j/7EdU//JoBv/5DWj/7EdU/66DUP+ug1D/7EdU/+xHVP/sR1T/7EdU/66DUP9sw0v/roNQ/w==")},
      {8, from_base64("dyNrgkgb2f5jDcPOO+Tryg=="),
       texels_of("G1kTRBtZE0QbWRNEG1kTRBtZE0QbWRNEG1kTRBtZE0QbWRNEG1kTRBtZE0QbWRNEG1kTRBtZE0QbWRNEG1kTRA==")},
      {9, from_base64("ry9Fs1IjR59ueU1XA34s/Q=="),
       texels_of("jcd8tnfMZrt3zGa7d8xmu6XBlLC7u6qqu7uqqo3HfLZ3zGa7u7uqqqXBlLCZETP/pcGUsKVsg4GqmapEqpmqRA==")},
      {10, from_base64("6uFad4l4HjchpVfY5acDKQ=="),
       texels_of("IGeIqSB3gaogknSsIL9gsCCiba4gknSsIK9nryDaU7IgknSsIOJQsyCiba4gv2CwIIB9qyBniKkgt2OvIHeBqg==")},
      {11, from_base64("bMuB2z9lz5wb3F0dj8g/Cw=="),
       texels_of("aL7kyYiw6KwmvuTJJrDorCaw6KxosOisJrDorIiw6Kwmk+9xRr7kyUa+5MkmvuTJJpPvcYiT73FGk+9xiL7kyQ==")},
      {12, from_base64("DrTbcb5XIgmFHT0k9MDPgw=="),
       texels_of("uS4LdaNJFbvBJAhauS4LdbkuC3XBJAharD4RoKNJFbvBJAhawSQIWqNJFbujSRW7sDkPkqNJFbvBJAhasDkPkg==")},
      {13, from_base64("/0Nj+C9HWXeJVfbO1oHL6g=="),
       texels_of("v2Ul2RzdVju/ZSU7HN1W2RzdVtkc3VY7HN1W2b9lJdm/ZSXZv2UlOxzdVju/ZSU7v2Ul2RzdVju/ZSU7v2UlOw==")},
      {14, from_base64("bXnO0sj4FKE0cv9wzjadgw=="),
       texels_of("jTo9q4wRIw+NT0r3jBEjD406PauMJS9bjTo9q4wRIw+MJS9bjTo9q4wlL1uMJS9bjBEjD41PSveMESMPjTo9qw==")},
      {15, from_base64("hUUqRPMYM38IzR5hTyNdPw=="),
       texels_of("x8fHz7GxsdmTk5PnpKSk36SkpN9jY2P8k5OT583Nzcx/f3/wnZ2d4oaGhu3Hx8fPjIyM6mpqavmGhobtY2Nj/A==")},
      {16, from_base64("lbxF/unuBAOnm+EYVERBMQ=="),
       texels_of("vr6+J5GRkRaRkZEW6enpOJGRkRbp6ek4kZGRFpGRkRbp6ek46enpOJGRkRaRkZEWurq6wbq6usE7OzvAurq6wQ==")},
      {17, from_base64("ZZMR+F4EKbGffsDhVvZaMw=="),
       texels_of("sbGxSCIiIokiIiJIsbGxiSIiIon39/dI9/f3dCIiIkj39/eJsbGxiWhoaHT39/eJaGhoibGxsV0iIiJ0aGhoXQ==")},
      {18, from_base64("KeeRuIDumV4/DTB9L7r0AA=="),
       texels_of("pxny/7UO9f+6CvX/xQH3/7MP9P+dIfH/lCnv/50h8f/DAvf/wAX2/6Ub8v+1DvX/pRvy/74G9v+ZJfD/lCnv/w==")},
  };
  return samples;
}

const HashedSample& uastc_pattern_blocks() {
  static const HashedSample sample{
      from_base64("XcwAIhD66SBneg3MiqzQf31kHJbey/uZ0+tQtrApWAed8Sl833veJVQ3yGbTPJ/tPYo5jDcVBxJ2Q/"
                  "GKlN04IV3QQsBMp8XysfO8+lzDM5+dJF"
                  "veVlV2Xjs5TyXbdOqC3YpocGMTsKkTL5r+d6N6Rv1ZcNoo4FEjfuwFWX72vMndZIQ+UcCcq8KngHW/"
                  "fCuDHbeX8JmjFdGe3tPWYjKQjD3jpfoA"
                  "KB373zWXImi7WjQ9GrFO50XBjRuj6NIA1M573QXI+ow4cFpCf6btMspylx3v1LiWszw89WOOl7MnXc2dP+7iV5IJ3lEYo/"
                  "fQZPYgXUr6xhMckn"
                  "c9t4mvuffyRl0HCwPTJ0cV2QYB+S6bXOWdeh1NEx4RbpH1rD3XGM8lfWwl27Z5YayWap8T+m3EMz0hMJHqL8TmQcH3/jcHlzdd/"
                  "EmdLJV3CAX8"
                  "rywcmGUzfXpXccLugliZXRy6il0KeP2ZaVeHa/jncycXoJ1BhrL9M3S/BLjdVizwLOSuEFIEvYyKT6M06iga4wYB6msW/"
                  "92InhdL8q91g3DU0f"
                  "D957B9Eqvb37n+DXfASH/ihLcIXeC0MQdBjNix17sSTW5/"
                  "ll20yAULmgdPQ8bJ7mmYP1H9vd5PsUDYFimKUsYxEzQsQwUJf29GSwZAeqUF1eLQ"
                  "1gNbEQJ2pV93OGdebcxekCADvCqle0g/"
                  "vawoKfzJTRYyow857CgB2g8aBCokozkwmQPVRt5IYVDl2N5uvW7D5QZDl1RqaWQdzsbOKody+64wA/"
                  "BtrjdjyBdUP4Oy8yiZBKPIfVz7aQBLgeSa8Mj+I7qjfIunyflAfrMPZUn69ljaQ7qS8vQomzcnApY+"
                  "B9GvUGMvr3rUhBVCUYF3Z37xcfrHUgxe"
                  "1MTl8J1ZxYCPNTdXR2QW7mbLnW/oCB/GTUB3UId/Jf5ZNRu/"
                  "LVWg4HZMPgrnjT0ajK1DETpOE4jgAW9nh4BD+tV7vj7ufEErFqpg2KejVUzjEe"
                  "e9hXcpSoknuYvnzG0UlXVWqfeydOoaNDmxh+Bx4Ho188eixSGRac9w7WcujHpaC1UmqqNEjuYQSqBndZos+V/"
                  "EJGQn2amEB3FxZwqgerz1Scm4"
                  "HHOvI+oK5UdftCq8xlzCHMVgihaDEAln180SCm4CXIk3y6OyF74pR5TbihOFsf9Wl4skwzDeJGe34vYtZIs+"
                  "g5rk30fAclsnVPjAXUWWD9Cm/q"
                  "HBi9HeB9oCVweV6KKSjQg3ukLlKGc/EAE4h45/yKZ3hYizIxTnNiA73StpnC9PR10ESE47"),
      0xd4546dbe7c043971ull};
  return sample;
}

const HashedSample& etc1s_large_file() {
  static const HashedSample sample{
      from_base64(
          "q0tUWCAyMLsNChoKAAAAAAEAAABgAAAAYAAAAAAAAAAAAAAAAQAAAAEAAAABAAAAaAAAADwAAACkAAAAJAAAAMgAAAAAAAAAbgQAAAAAAAA2"
          "BQ"
          "AAAAAAAAEDAAAAAAAAAAAAAAAAAAA8AAAAAAAAAAIAOACjAQIAAwMAAAgIAAAAAAAAAAA/AAAAAAAAAAAA/////0AAPw8AAAAAAAAAAP////"
          "8f"
          "AAAAS1RYd3JpdGVyAEJhc2lzIFVuaXZlcnNhbCAyLjEwAAANAbcAAgIAAIYBAAC+"
          "AAAAAAAAAAAAAAAAAAAAmgEAAJoBAABnAQAAIEAkCGoYiI"
          "Fgj1b+MNiBURWHxCsQIAIAJwjDUDSvTWC4eYqTA5q2HwSIBbAJw0AMfb4OdRPnIo1+QJvECMAEAAEAAEEYNgk6j/"
          "OwJuZqS3rXwLVVmnGdLG5p"
          "AU+vzV5Pn/L8i9uaIIi1JZo+iHcp0i/v/7DhuBNRjGYlTEcuerXdxWyRyvP/"
          "cq9tUlTT+MGYmIUuWRa22bMBG2aD9hv3Cn+2u7TlxpXuc+D80i"
          "zQnFqRMoFx2ayYGxbaPGpPIp3OR7Olzenm25uny0Prgcygq+"
          "Xpoaar2NH5Rw7swohaHzECFsCdF5unmxvTUPKYBYQMaJRgNmAB4mAyy5iJbGoP"
          "Au0Ip9krA6TTL74HO+1sQRtMYHlMIdP/AWDfh6Oz+TRh9jF1ZffTHEw/"
          "RSmR3TKY0uSiCKvE5pVFKmbLbFqvTVNIeHffm50nrJM6eNi85Hbqik"
          "1Mh4rZsmvzld5vlhvpap8s48GOKZjSzIEDp/K2hqc/pw9LMwJRad/"
          "wA34fu33fdbeIIIkkkgAAAAAAAAAAAACAJJJUlSSqiiRVJcmqqvPviweB"
          "LVCBk9Iyw7GEW/bS1cZgLCiB7LR1rB1j2hksE3Ls4eIDbHrZmV46IrBV2sobk6IwjDu95kLE6mhvdwwEPYY60gC/"
          "h2cFJSg7MtuZtZGQIwJRu1"
          "KCy2P27j/aqsVSA+gH5ghsFFcYAODvz3uzNGP5R4tJ41wg1axkmlT/aJVukYbI6XKCVE6ZNgdAGwkOgYQQB6B4SFRULjgCBaLyASBN1/"
          "c37x8J"
          "bqBgRlAQlCRYQOrgF1105RNYisMJmTSKUVldyiXratSvfB8k2zYaiKUIlNbRzAlZIRcoBGiBKRhBBzpNgIrAULHU3k3g4lHcP+"
          "8cqLFBoPAkjE"
          "mjF2psfzaM4ySgMEOiETDrsEQie6zDAYqYWVkCskPIvkbqLtzJe66TyLFmdpJW0OXWbbufLvED9WHbzOT1brfbqTrfpvMfL9bYxe032yhili"
          "p+"
          "/+8lFkQ4PnAZ095oaknKHHep+nXo1LLWGphvKE57RQ8UoRn0KZohnW/S1qsLaJvFlLatHjbBdIt2aZp5ukY8Le+/"
          "VkFc8DgjHl9XVRGH0ylCGe"
          "qvt5Ha80zz8XhujIeP01UYirT0sS76off+6nz+/83riibRHfWydIzck5v4wt0/359FXn1++e63Z9Ny3//"
          "9+0mcfn4xHmrjBwFB3ABhEAij8Bsg"
          "zY+"
          "bxAEc5Ua5fRRiHwsDKWwOUloemSBFEEGU7zUEcT2kygCMwz3v5zEtlJAKTkhFtbREEF1I1FRL0FZjY3fSFLR4A01tbdFWUxBI1GSDBKKI+A"
          "c+jofz/"
          "h58oBG0Rg2FNy7dCW7Eg6KCx0JEN4riAYLowgMXitSVF6iIv2AluBDBjS4UXHjhH0AQ9L3vHcnLe2ln8pImk7YyPZLpTNNMJ83MtFOn"
          "DBAwIUAAAAAABFHHBALN2puyCqYPBdxjKRDyCfmEfEI+IR9YzpgbKzbHRX7yT0+e9rt16cSTPqd8ZOGH+X8ZeL1485VbjObJriMVGq/"
          "BZLoqDr"
          "Wcxe6o4/fdeoYJOqhJQ6itWhUbz/XhDGgFTfHVlxfjFlqhYxy9OFRnQl1J1+J1WkZcs2Q2gqlCccvCwtFZ0BED+Etr8X/"
          "BaKw+FrQkstEZ0lcK"
          "YomOTsttcYz24vcab3luhkf9OifIz8KxhtdkCKPkG1PXz1ZfPPc8I5G88q60FVvMWXXEH/+r/GefB/"
          "DrcKCzxrEAtZFe+N0mJM2IFvYseGwFMP"
          "AGyk+wdaGPmmFESZPneEdy9n2rDmhILKl3V5HdNS9n+8EX64i9fFhN5w+"
          "YWhAtHNJ105LKSizYUtuZZarvdJGpdHvxQ4h4gB46yyOd2toeRe3w"
          "R3Cm7iHUHbGSnmYSiWyu+glP4ypEIpnotnEBY4BguFg4T9OFy0u8QCALAAKju6Hejk4YsBC/"
          "6b9TyWOlRCRlzt6YikPfvy7hABIO27yks8MUgs"
          "LSCSn+NxtIIQDGKM2nv2UVTB8KuMdSIOQT8gn5hHxCPunSh/pYa7yKuUwupGGCYh3uYEZvlen67IZ+kaxEp4jQFMhvkwKiJh1xf0zR6/"
          "SNYz31"
          "OoliwM+T50usRR9sBbOScnsaflz//sQvdIjpZqcvx425vVhr3KFNCkFN/Jqt6rsKaOyb98t2+rNonp2eit/XykxkalVVd/eC9z/"
          "8codqB332ud"
          "zk663jlXNb/uNZu+SIS+Rk2OaLYXjdK5uUuvVt2rvh/gOrOZhZA7uZ8l/"
          "cHJWmPUnIXNUKHm69PfgIDLC3ZWxGab2z4yTGhthMBcNoHAy1jIuU"
          "cA0FZ5w5JnblHc+tMdJJxVwjIIk7mXlDldzeUEf1+72YtJi5wvrbSGBugLkh0dqkYTcEYRsPYkBIEpLQ5nWVTR2FHblGIsnc1cF+"
          "IndEwUcSJj"
          "5klJXY4qT4hqWlQOowuWqETdeJrOLVNtKFEgLv6eyu25aCuaGG3AVt"),
      0x26302bfbc504b879ull};
  return sample;
}

std::vector<std::byte> write_ktx2(std::uint32_t width, std::uint32_t height, std::uint32_t vk_format,
                                  std::uint8_t color_model, std::uint8_t channel, std::span<const std::byte> level) {
  constexpr std::uint32_t kDescriptor = 104, kDescriptorSize = 44, kLevel = 160;
  std::vector<std::byte> out;
  for (const unsigned char c : std::string_view("\xabKTX 20\xbb\r\n\x1a\n")) append(out, c);
  for (const std::uint32_t word : {vk_format, 1u, width, height, 0u, 0u, 1u, 1u, 0u}) append(out, word);
  for (const std::uint32_t word : {kDescriptor, kDescriptorSize, 0u, 0u}) append(out, word);
  for (const std::uint64_t word : {std::uint64_t{0}, std::uint64_t{0}, std::uint64_t{kLevel},
                                   std::uint64_t{level.size()}, std::uint64_t{level.size()}})
    append(out, word);
  append(out, kDescriptorSize);
  append(out, std::uint32_t{0});                    // vendor and type of the descriptor
  append(out, std::uint16_t{2});                    // version
  append(out, std::uint16_t{kDescriptorSize - 4});  // size of the block
  append(out, std::uint32_t{color_model});
  out.resize(kDescriptor + 28);
  append(out, std::uint32_t{channel} << 24 | 127u << 16);
  out.resize(kLevel);
  out.insert(out.end(), level.begin(), level.end());
  return out;
}

}  // namespace sinew::test
