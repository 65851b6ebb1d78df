// Monte Carlo localisation in the corridor: only the lidar and a map of the walls
#include "eyebot++.h"
#include <random>
#include <vector>
#include <algorithm>
using namespace std;

struct Particle { double x, y, phi, weight; };

const double walls[8][4] = {{0,0,3600,0}, {3600,0,3600,2400}, {3600,2400,0,2400}, {0,2400,0,0},
                            {600,600,3000,600}, {3000,600,3000,1800}, {3000,1800,600,1800}, {600,1800,600,600}};

double ray(double x, double y, double a)
{
  double best = 9999, dx = cos(a), dy = sin(a);
  for (auto &w : walls)
  {
    double ex = w[2] - w[0], ey = w[3] - w[1], det = dx * -ey + dy * ex;
    if (fabs(det) < 1e-9) continue;
    double t = ((w[0] - x) * -ey + (w[1] - y) * ex) / det, u = (dx * (w[1] - y) - dy * (w[0] - x)) / det;
    if (t > 0 && u >= 0 && u <= 1) best = min(best, t);
  }
  return best;
}

int main()
{
  mt19937 gen(42);   // we know the quarter, the corridor looks the same from both ends
  uniform_real_distribution<double> ux(100, 1800), uy(100, 1200), uphi(-M_PI, M_PI);
  normal_distribution<double> noise(0, 1);
  vector<Particle> p(400);
  for (auto &q : p) q = {ux(gen), uy(gen), uphi(gen), 1};

  LCDMenu("", "", "", "END");
  int scan[360];
  for (int step = 0; step < 12; step++)
  {
    int x, y, z, phi;
    LIDARGet(scan);
    for (auto &q : p)
    {
      q.weight = 1e-9;
      double err = 0;
      for (int i = 0; i < 360; i += 45) err += fabs(min(ray(q.x, q.y, q.phi + (180 - i) * M_PI / 180), 1500.0) - min(scan[i], 1500));
      q.weight += exp(-err / 400);
    }
    double sum = 0;
    for (auto &q : p) sum += q.weight;
    // low variance resampling
    vector<Particle> n;
    double r = uniform_real_distribution<double>(0, sum / p.size())(gen), c = p[0].weight;
    size_t k = 0;
    for (size_t m = 0; m < p.size(); m++)
    {
      while (r + m * sum / p.size() > c && k < p.size() - 1) c += p[++k].weight;
      n.push_back({p[k].x + 25 * noise(gen), p[k].y + 25 * noise(gen), p[k].phi + 0.05 * noise(gen), 1});
    }
    p = n;
    LCDArea(10, 50, 370, 290, NAVY, 1);
    for (auto &w : walls) LCDLine(10 + w[0] / 10, 290 - w[1] / 10, 10 + w[2] / 10, 290 - w[3] / 10, WHITE);
    for (auto &q : p) LCDPixel(10 + q.x / 10, 290 - q.y / 10, YELLOW);
    SIMGetRobot(0, &x, &y, &z, &phi);
    LCDCircle(10 + x / 10, 290 - y / 10, 6, RED, 0);
    int turn = PSDGet(PSD_FRONT) < 350 ? 90 : 0;
    if (turn) { VWTurn(turn, 60); VWWait(); } else { VWStraight(250, 250); VWWait(); }
    for (auto &q : p) { q.phi += turn * M_PI / 180; if (!turn) { q.x += 250 * cos(q.phi); q.y += 250 * sin(q.phi); } }
  }
  vector<double> xs, ys;
  for (auto &q : p) { xs.push_back(q.x); ys.push_back(q.y); }
  nth_element(xs.begin(), xs.begin() + 200, xs.end());
  nth_element(ys.begin(), ys.begin() + 200, ys.end());
  int x, y, z, phi;
  SIMGetRobot(0, &x, &y, &z, &phi);
  printf("estimate is %s\n", hypot(xs[200] - x, ys[200] - y) < 150 ? "good" : "bad");
  LCDSetPrintf(0, 0, "estimate %.0f %.0f, true %d %d", xs[200], ys[200], x, y);
  return 0;
}
